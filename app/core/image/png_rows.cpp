#include "core/image/png_rows.h"

#include "core/base/beside.h"
#include "core/base/system.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>

namespace normalscope {

// libpng reports errors by longjmp, which must not pass over a destructor: the functions that it leaves so have none.
struct PngRows::Decoder {
    std::FILE* file = nullptr;
    png_structp png = nullptr;
    png_infop info = nullptr;
    bool failed = true;

    ~Decoder() {
        png_destroy_read_struct(&png, &info, nullptr);
        if (file) std::fclose(file);
    }
    static void on_error(png_structp of, png_const_charp) { png_longjmp(of, 1); }
    static void on_warning(png_structp, png_const_charp) {}

    bool begin() {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
        info = png ? png_create_info_struct(png) : nullptr;
        if (!info || !file) return false;
        if (setjmp(png_jmpbuf(png))) return false;
        png_init_io(png, file);
        png_set_user_limits(png, kLongestSide, kLongestSide);
        png_read_info(png, info);
        const auto color = png_get_color_type(png, info);
        constexpr png_uint_32 kOwnColors =
            PNG_INFO_gAMA | PNG_INFO_cHRM | PNG_INFO_iCCP | PNG_INFO_sRGB | PNG_INFO_tRNS;
        if (png_get_bit_depth(png, info) != 8 || png_get_interlace_type(png, info) != PNG_INTERLACE_NONE ||
            (color != PNG_COLOR_TYPE_RGB && color != PNG_COLOR_TYPE_RGBA) || png_get_valid(png, info, kOwnColors) != 0)
            return false;
        if (color == PNG_COLOR_TYPE_RGB) png_set_filler(png, 255, PNG_FILLER_AFTER);
        png_read_update_info(png, info);
        return true;
    }
    bool read(Image& to) {
        if (setjmp(png_jmpbuf(png))) return false;
        for (int y = 0; y < to.size.y; ++y) png_read_row(png, to.pixel(0, y), nullptr);
        return true;
    }
};

PngRows::PngRows(const std::filesystem::path& file) : decoder_(std::make_unique<Decoder>()) {
    decoder_->file = open_file(file, "rb");
    decoder_->failed = !decoder_->begin();
}
PngRows::~PngRows() = default;

bool PngRows::failed() const { return decoder_->failed; }

glm::ivec2 PngRows::size() const {
    return {static_cast<int>(png_get_image_width(decoder_->png, decoder_->info)),
            static_cast<int>(png_get_image_height(decoder_->png, decoder_->info))};
}

void PngRows::read(Image& to) { decoder_->failed = decoder_->failed || !decoder_->read(to); }

std::optional<ImageDifference> difference_by_rows(const std::filesystem::path& actual,
                                                  const std::filesystem::path& expected, const Tolerance& tolerance) {
    constexpr int kRows = 64;
    PngRows of_actual(actual), of_expected(expected);
    if (of_actual.failed() || of_expected.failed() || of_actual.size() != of_expected.size()) return std::nullopt;
    const glm::ivec2 size = of_expected.size();
    if (std::int64_t{size.x} * size.y <= kMostLookedAt) return std::nullopt;
    Differences differences(size, tolerance);
    Image a, b;
    for (int y = 0; y < size.y; y += kRows) {
        const glm::ivec2 part(size.x, std::min(kRows, size.y - y));
        if (a.size != part) a = make_image(part), b = make_image(part);
        Beside<void> other = beside([&] { of_actual.read(a); });
        of_expected.read(b);
        other.get();
        if (of_actual.failed() || of_expected.failed()) return std::nullopt;
        differences.add(a, b, y);
    }
    return differences.result();
}

}  // namespace normalscope
