#pragma once

#include "core/image/image.h"
#include "core/image/image_difference.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace normalscope {

/// A PNG picture's rows, one after the other, of which no more are held than are asked for.
class PngRows {
public:
    /// Fails where it is not of the kind that this program writes, 8 bits of sRGB without interlacing, and for what is no
    /// PNG at all: read_png reads, or refuses, everything else.
    explicit PngRows(const std::filesystem::path& file);
    ~PngRows();
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    bool failed() const;
    glm::ivec2 size() const;
    /// The next rows, as many as the picture `to` has. Fails where the file is damaged.
    void read(Image& to);

private:
    struct Decoder;
    std::unique_ptr<Decoder> decoder_;
};

/// How far two large pictures of one size are apart, of which neither is held. Empty where they are small, or of a kind
/// that has to be read whole.
std::optional<ImageDifference> difference_by_rows(const std::filesystem::path& actual,
                                                  const std::filesystem::path& expected, const Tolerance& tolerance);

}  // namespace normalscope
