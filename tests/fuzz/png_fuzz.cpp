// Any bytes as a picture.

#include "core/base/error.h"
#include "core/image/png.h"
#include "fuzz.h"

namespace normalscope::fuzz {

void check(std::string_view bytes) {
    try {
        const Image image = decoded_png(bytes, "picture.png");
        require(image.size.x > 0 && image.size.y > 0, "a picture without pixels");
        if (image.rgba.size() > 1 << 20) return;  // encoding takes its time
        require(decoded_png(png_bytes(image), "again").rgba == image.rgba,
                "a picture that is written reads back as another");
    } catch (const InputError& e) {
        require(std::string_view(e.what()).find('\n') == std::string_view::npos, "an error is not one line");
    }
}

std::vector<std::string_view> words() {
    return {"\x89PNG\r\n\x1a\n",
            "IHDR",
            "PLTE",
            "tRNS",
            "IDAT",
            "IEND",
            "gAMA",
            "sRGB",
            "iCCP",
            "zTXt",
            "cHRM",
            std::string_view("\0\0\x40\0", 4),
            std::string_view("\0\0\0\0", 4),
            std::string_view("\0\0\0\x0d", 4),
            std::string_view("\x10\x06\0\0\0", 5),
            std::string_view("\x08\x03\0\0\1", 5),
            "\xff\xff\xff\xff"};
}

}  // namespace normalscope::fuzz
