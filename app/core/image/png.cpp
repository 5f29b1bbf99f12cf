#include "core/image/png.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/system.h"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>

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

namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) { throw InputError(name + ": " + what); }

/// libpng's simplified interface: it turns every kind of PNG into one format, and longjmps nowhere.
struct Decoder {
    png_image png{.opaque = nullptr, .version = PNG_IMAGE_VERSION};

    Decoder() = default;
    ~Decoder() { png_image_free(&png); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// Once it has begun to read from so many bytes.
    Image finish(std::uintmax_t bytes, const std::string& name) {
        // Judged before anything is allocated for the pixels: a small file can claim any size.
        const std::int64_t pixels = std::int64_t{png.width} * png.height;
        const std::string size = std::to_string(png.width) + "x" + std::to_string(png.height);
        if (png.width > kLongestSide || png.height > kLongestSide || pixels > kMostPixels)
            fail(name, "is a picture of " + size + " pixels; at most " + std::to_string(kLongestSide) + " a side and " +
                           std::to_string(kMostPixels) + " in all are read");
        if (static_cast<std::uintmax_t>(pixels / 8 / kBestDeflateRatio) > bytes)
            fail(name,
                 "is a damaged PNG picture: its " + std::to_string(bytes) + " bytes cannot hold " + size + " pixels");

        png.format = PNG_FORMAT_RGBA;
        png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits without a gamma: as pictures are, not linear
        Image image = make_image({static_cast<int>(png.width), static_cast<int>(png.height)});
        if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr)) damaged(name);
        return image;
    }
    [[noreturn]] void damaged(const std::string& name) const {
        fail(name, "is a damaged PNG picture: " + std::string(png.message));
    }
};

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

// A file of many megabytes is not held beside its pixels.
Image decoded_from(std::FILE* file, std::uintmax_t bytes, const std::string& name) {
    Decoder decoder;
    if (!png_image_begin_read_from_stdio(&decoder.png, file)) decoder.damaged(name);
    return decoder.finish(bytes, name);
}

}  // namespace

Image read_png(const std::filesystem::path& file) {
    constexpr std::uintmax_t kLarge = std::uintmax_t{1} << 24;
    std::error_code error;
    const std::uintmax_t bytes =
        std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
    if (!error && bytes > kLarge && bytes <= kLargestPngFile && png_size(file)) {
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(open_file(file, "rb"), std::fclose);
        if (stream) return decoded_from(stream.get(), bytes, file.string());
    }
    return decoded_png(read_file(file, kLargestPngFile), file.string());
}

Image decoded_png(std::string_view bytes, const std::string& name) {
    if (bytes.empty()) fail(name, "is empty, so it is not a PNG picture");
    if (!bytes.starts_with(kSignature)) fail(name, "is not a PNG picture");
    Decoder decoder;
    if (!png_image_begin_read_from_memory(&decoder.png, bytes.data(), bytes.size())) decoder.damaged(name);
    return decoder.finish(bytes.size(), name);
}

std::optional<glm::ivec2> png_size(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    std::array<char, 24> head{};  // the signature, a length, "IHDR", the width and the height
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), head.size());
    const std::string_view bytes(head.data(), static_cast<std::size_t>(in.gcount()));
    if (bytes.size() < head.size() || !bytes.starts_with(kSignature) || bytes.substr(12, 4) != "IHDR")
        return std::nullopt;
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
        return value;
    };
    const std::uint32_t width = number(16), height = number(20);
    if (width == 0 || height == 0 || width > kLongestSide || height > kLongestSide ||
        std::int64_t{width} * height > kMostPixels)
        return std::nullopt;
    return glm::ivec2(static_cast<int>(width), static_cast<int>(height));
}

}  // namespace normalscope
