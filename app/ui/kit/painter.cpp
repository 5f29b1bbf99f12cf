#include "ui/kit/painter.h"

#include <imgui.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

struct Corner {
    glm::dvec2 at;  // in pixels, on a grid of 1/256: products of two are exact
    glm::vec2 uv;
    glm::vec4 color;  // 0 … 255
};

/// The one texture that there is: how much of a letter, or of a line's edge, covers each texel.
class Atlas {
public:
    explicit Atlas(const ImFontAtlas& fonts)
        : coverage_(fonts.TexPixelsAlpha8), size_(fonts.TexWidth, fonts.TexHeight) {}

    float at(const glm::vec2& uv) const {  // bilinear, between texels' centres
        const glm::vec2 place = uv * glm::vec2(size_) - 0.5f, low = glm::floor(place), share = place - low;
        const glm::ivec2 a = glm::clamp(glm::ivec2(low), glm::ivec2(0), size_ - 1);
        const glm::ivec2 b = glm::clamp(glm::ivec2(low) + 1, glm::ivec2(0), size_ - 1);
        return glm::mix(glm::mix(texel(a.x, a.y), texel(b.x, a.y), share.x),
                        glm::mix(texel(a.x, b.y), texel(b.x, b.y), share.x), share.y) /
               255.0f;
    }

private:
    float texel(int x, int y) const { return coverage_[static_cast<std::ptrdiff_t>(y) * size_.x + x]; }

    const unsigned char* coverage_;
    glm::ivec2 size_;
};

// For what is never negative; std::lround would be a call for every pixel.
std::uint8_t rounded(float channel) {
    constexpr float kHalf = 0.5f;
    return static_cast<std::uint8_t>(channel + kHalf);
}

void blend(std::uint8_t* pixel, const glm::vec4& color, float coverage) {
    const float alpha = color.a / 255.0f * coverage;
    for (int i = 0; i < 3; ++i) pixel[i] = rounded(glm::mix(float(pixel[i]), color[i], alpha));
    pixel[3] = rounded(255.0f * alpha + float(pixel[3]) * (1.0f - alpha));
}

/// How far a place is to the left of the line between two corners, times their distance; grows by a constant a pixel.
struct Edge {
    Edge(const glm::dvec2& from, const glm::dvec2& to)
        : along(to - from), start(from), takes_what_lies_on_it(along.y < 0.0 || (along.y == 0.0 && along.x > 0.0)) {}
    double operator()(const glm::dvec2& p) const { return along.x * (p.y - start.y) - along.y * (p.x - start.x); }
    bool takes(double distance) const { return distance > 0.0 || (distance == 0.0 && takes_what_lies_on_it); }

    glm::dvec2 along, start;
    bool takes_what_lies_on_it;  // so that of two triangles with a common edge, one takes each pixel
};

void fill(Image& image, const Atlas& atlas, std::array<Corner, 3> c, const glm::ivec4& clip) {
    double area = Edge(c[0].at, c[1].at)(c[2].at);
    if (area == 0.0) return;
    if (area < 0.0) {
        std::swap(c[1], c[2]);
        area = -area;
    }
    const glm::ivec2 low =
        glm::max(glm::ivec2(glm::floor(glm::min(glm::min(c[0].at, c[1].at), c[2].at))), glm::ivec2(clip.x, clip.y));
    const glm::ivec2 high =
        glm::min(glm::ivec2(glm::ceil(glm::max(glm::max(c[0].at, c[1].at), c[2].at))), glm::ivec2(clip.z, clip.w));
    const std::array edges{Edge(c[1].at, c[2].at), Edge(c[2].at, c[0].at), Edge(c[0].at, c[1].at)};
    const bool plain = c[0].uv == c[1].uv && c[1].uv == c[2].uv && c[0].color == c[1].color && c[1].color == c[2].color;
    const float plain_coverage = plain ? atlas.at(c[0].uv) : 0.0f;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) {
            const glm::dvec2 centre(x + 0.5, y + 0.5);
            const std::array distances{edges[0](centre), edges[1](centre), edges[2](centre)};
            if (!edges[0].takes(distances[0]) || !edges[1].takes(distances[1]) || !edges[2].takes(distances[2]))
                continue;
            if (plain) {
                blend(image.pixel(x, y), c[0].color, plain_coverage);
                continue;
            }
            const auto b = static_cast<float>(distances[1] / area), d = static_cast<float>(distances[2] / area);
            const float a = 1.0f - b - d;
            blend(image.pixel(x, y), a * c[0].color + b * c[1].color + d * c[2].color,
                  atlas.at(a * c[0].uv + b * c[1].uv + d * c[2].uv));
        }
}

Corner corner(const ImDrawVert& vertex) {
    const auto channel = [&](int shift) { return static_cast<float>(vertex.col >> shift & 0xFF); };
    return {
        glm::round(256.0 * glm::dvec2(vertex.pos.x, vertex.pos.y)) / 256.0,
        {vertex.uv.x, vertex.uv.y},
        {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT), channel(IM_COL32_A_SHIFT)}};
}

}  // namespace

void paint(const ImDrawData& data, Image& image) {
    const Atlas atlas(*ImGui::GetIO().Fonts);
    for (const ImDrawList* list : data.CmdLists)
        for (const ImDrawCmd& command : list->CmdBuffer) {
            const ImVec4& r = command.ClipRect;
            const glm::ivec4 clip(std::max(static_cast<int>(r.x), 0), std::max(static_cast<int>(r.y), 0),
                                  std::min(static_cast<int>(r.z), image.size.x),
                                  std::min(static_cast<int>(r.w), image.size.y));
            const ImDrawIdx* index = list->IdxBuffer.Data + command.IdxOffset;
            const auto next = [&] { return corner(list->VtxBuffer[static_cast<int>(command.VtxOffset + *index++)]); };
            for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
                const Corner a = next(), b = next(), c = next();
                fill(image, atlas, {a, b, c}, clip);
            }
        }
}

}  // namespace normalscope
