#include "core/image/png.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <png.h>

#include <csetjmp>
#include <cstdint>

namespace normalscope {

namespace {

constexpr std::size_t kLargestPngFile = std::size_t{1} << 30;
// Deflate cannot pack better than this, so a file's length bounds the pixels that it can hold.
constexpr std::int64_t kBestDeflateRatio = 1032;

bool is_opaque(const Image& image) {
    std::uint8_t all = 255;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) all &= image.rgba[i];
    return all == 255;
}

// libpng reports errors by longjmp, which must not pass over a destructor: everything that has one lives in the caller.
struct Encoder {
    std::string& bytes;
    std::string error;
    png_structp png = nullptr;
    png_infop info = nullptr;

    ~Encoder() { png_destroy_write_struct(&png, &info); }
};

void on_error(png_structp png, png_const_charp what) {
    static_cast<Encoder*>(png_get_error_ptr(png))->error = what;
    png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}
void on_bytes(png_structp png, png_bytep data, std::size_t size) {
    static_cast<Encoder*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), size);
}

bool encode(Encoder& e, const Image& image, bool opaque) {
    e.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &e, on_error, on_warning);
    e.info = e.png ? png_create_info_struct(e.png) : nullptr;
    if (!e.info) return false;
    if (setjmp(png_jmpbuf(e.png))) return false;

    png_set_write_fn(e.png, &e, on_bytes, nullptr);
    png_set_user_limits(e.png, kLongestSide * 4, kLongestSide * 4);
    // Measured on rendered 1280x720 pictures: their rows are mostly runs of one colour, which deflate packs best as they
    // are. No filter at level 1 takes 8 ms; each single filter takes longer and packs less, and trying all takes 24 ms.
    png_set_filter(e.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_compression_level(e.png, 1);
    png_set_IHDR(e.png, e.info, static_cast<png_uint_32>(image.size.x), static_cast<png_uint_32>(image.size.y), 8,
                 opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(e.png, e.info);
    if (opaque) png_set_filler(e.png, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < image.size.y; ++y) png_write_row(e.png, image.pixel(0, y));
    png_write_end(e.png, nullptr);
    return true;
}

}  // namespace

std::string png_bytes(const Image& image) {
    std::string bytes;
    // Room for the whole, so that appending inside libpng's callback cannot throw through C code.
    bytes.reserve(image.rgba.size() + image.rgba.size() / 64 + (std::size_t{1} << 16));
    Encoder encoder{bytes, {}};
    if (!encode(encoder, image, is_opaque(image)))
        throw InputError("the picture could not be encoded as PNG: " +
                         (encoder.error.empty() ? "no memory" : encoder.error));
    return bytes;
}

void write_png(const std::filesystem::path& file, const Image& image) { write_file(file, png_bytes(image)); }

Image read_png(const std::filesystem::path& file) {
    return decoded_png(read_file(file, kLargestPngFile), file.string());
}

Image decoded_png(std::string_view bytes, const std::string& name) {
    const auto fail = [&](const std::string& what) { throw InputError(name + ": " + what); };
    if (bytes.empty()) fail("is empty, so it is no PNG picture");
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n")) fail("is no PNG picture");

    // libpng's simplified interface: it turns every kind of PNG into one format, and longjmps nowhere.
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    struct Free {
        png_image& png;
        ~Free() { png_image_free(&png); }
    } const free_at_end{png};
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
        fail("is a damaged PNG picture: " + std::string(png.message));
    // Judged before anything is allocated for the pixels: a small file can claim any size.
    const std::int64_t pixels = std::int64_t{png.width} * png.height;
    const std::string size = std::to_string(png.width) + "x" + std::to_string(png.height);
    if (png.width > kLongestSide || png.height > kLongestSide || pixels > kMostPixels)
        fail("is a picture of " + size + " pixels; at most " + std::to_string(kLongestSide) + " a side and " +
             std::to_string(kMostPixels) + " in all are read");
    if (pixels / 8 / kBestDeflateRatio > static_cast<std::int64_t>(bytes.size()))
        fail("is a damaged PNG picture: its " + std::to_string(bytes.size()) + " bytes cannot hold " + size +
             " pixels");

    png.format = PNG_FORMAT_RGBA;
    png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits without a gamma: as pictures are, not linear
    Image image = make_image({static_cast<int>(png.width), static_cast<int>(png.height)});
    if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr))
        fail("is a damaged PNG picture: " + std::string(png.message));
    return image;
}

}  // namespace normalscope
