#pragma once

#include <cstddef>

// What the program asks of the page around it: functions of the object that the page hands to the engine, by library.js.
// Texts are UTF-8.

extern "C" {
void page_copy(const char* text);
void page_title(const char* text);
void page_cursor(const char* name);
/// The settings' JSON, or an unsaved scene's; empty: none.
void page_remember(const char* key, const char* text);
int page_is_full_screen();
void page_toggle_full_screen();
void page_choose_file();
void page_download(const char* name, const char* bytes, std::size_t size);
/// A letter by the browser's fonts: how much of each pixel it covers, which the caller frees, and its width, height, left,
/// above and advance, as LetterPicture has them. Null: there is none.
unsigned char* page_draw_letter(unsigned letter, float em, float* measures);
/// This page's own address, with a name or link in it; the caller frees it.
char* page_address(const char* name);
}
