/* What newer versions of the C library than 2.34 have, by what 2.34 has: then the program starts with any of them. */

#include <stdint.h>
#include <sys/random.h>

/* For libstdc++'s std::random_device; in the C library since 2.36. */
uint32_t arc4random(void);
uint32_t arc4random(void) {
    uint32_t bits = 0;
    while (getrandom(&bits, sizeof bits, 0) != sizeof bits) {
    }
    return bits;
}

/* Made anew in 2.35. The linker sends calls of hypot to __wrap_hypot. */
double old_hypot(double x, double y);
float old_hypotf(float x, float y);
__asm__(".symver old_hypot, hypot@GLIBC_2.2.5");
__asm__(".symver old_hypotf, hypotf@GLIBC_2.2.5");

/* NOLINTBEGIN(bugprone-reserved-identifier): the linker has it so */
double __wrap_hypot(double x, double y);
double __wrap_hypot(double x, double y) { return old_hypot(x, y); }
float __wrap_hypotf(float x, float y);
float __wrap_hypotf(float x, float y) { return old_hypotf(x, y); }
/* NOLINTEND(bugprone-reserved-identifier) */
