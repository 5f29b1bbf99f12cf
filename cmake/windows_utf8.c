/* Narrow text is UTF-8. The program's manifest says so to Windows; but the C library in which libstdc++ makes a path of narrow
   text takes each byte for a letter. The linker sends its calls of mbrtowc here. */

#include <stddef.h>
#include <wchar.h>

#define FAILED ((size_t)-1)
#define INCOMPLETE ((size_t)-2)

/* How many bytes a character has, by its first one; 0 where no character begins with that. */
static size_t length_of(unsigned char first) {
    if (first < 0x80) return 1;
    if (first < 0xC2) return 0;
    if (first < 0xE0) return 2;
    if (first < 0xF0) return 3;
    return first < 0xF5 ? 4 : 0;
}

/* A character of four bytes becomes two units of UTF-16. The second one waits in the state, as it comes with the last byte. */
size_t __wrap_mbrtowc(wchar_t* to, const char* from, size_t count, mbstate_t* state);
size_t __wrap_mbrtowc(wchar_t* to, const char* from, size_t count, mbstate_t* state) {
    static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (!from) return 0;
    if (count == 0) return INCOMPLETE;
    if (state && *state != 0) {
        if (to) *to = (wchar_t)*state;
        *state = 0;
        return 1;
    }
    const size_t length = length_of((unsigned char)*from);
    if (length == 0) return FAILED;
    if (length > count) return INCOMPLETE;
    unsigned long character = length == 1 ? (unsigned char)*from : (unsigned char)*from & (0x7FU >> length);
    for (size_t i = 1; i < length; ++i) {
        if (((unsigned char)from[i] & 0xC0) != 0x80) return FAILED;
        character = character << 6 | ((unsigned char)from[i] & 0x3F);
    }
    if (character < least[length] || character > 0x10FFFF || (character >= 0xD800 && character < 0xE000)) return FAILED;
    if (length == 4) {
        character -= 0x10000;
        if (!state) return FAILED;
        *state = (mbstate_t)(0xDC00 + (character & 0x3FF));
        character = 0xD800 + (character >> 10);
    }
    if (to) *to = (wchar_t)character;
    return character == 0 ? 0 : length == 4 ? 3 : length;
}
