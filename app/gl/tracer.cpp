#include "gl/tracer.h"

#include "core/program/ray_samples.h"
#include "gl/driver.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <bit>

namespace normalscope {

namespace {

constexpr int kMostExactDegree = 10;  // beyond, floats no longer tell the coefficients apart
constexpr int kMostExactDegreeInDoubles = 20;
constexpr int kOtherwise = 6;

// |x|, min or a root has kinks, which hide between an interpolant's samples.
bool has_kinks(const formulas::Graph& graph) {
    for (formulas::Id id = 0; id < graph.size(); ++id) {
        const formulas::Node& node = graph[id];
        switch (node.op) {
            case formulas::Op::Abs:
            case formulas::Op::Sign:
            case formulas::Op::Floor:
            case formulas::Op::Atan2:
            case formulas::Op::Min:
            case formulas::Op::Max:
            case formulas::Op::Where: return true;
            case formulas::Op::Power:
                if (const formulas::Id exponent = graph.args(id)[1];
                    graph.is_number(exponent) && !graph[exponent].number.integer())
                    return true;
                break;
            default: break;
        }
    }
    return false;
}

std::string generated(const ImplicitSurface& surface, formulas::Precision precision) {
    const int most = precision == formulas::Precision::Double ? kMostExactDegreeInDoubles : kMostExactDegree;
    const bool exact = surface.degree() && *surface.degree() <= most;
    const int degree = exact ? std::max(*surface.degree(), 1) : kOtherwise;
    return surface.glsl(precision).source + formulas::ray_samples_glsl(degree, precision) +
           "const REAL CAUTION = " + (has_kinks(surface.tame_formula().graph) ? "24.0" : "2.0") + ";\n" +
           "const bool POLYNOMIAL = " + (exact ? "true" : "false") + ";\n";
}

// Where the box lies in the picture, in GL's pixels, and one pixel around it; the whole picture where a part is behind the eye.
PixelRect box_in_picture(const formulas::Box& box, const CameraView& view, glm::ivec2 size,
                         const glm::dmat4& object_from_world) {
    const glm::dmat4 clip_from_object = view.clip_from_world() * glm::inverse(object_from_world);
    glm::dvec2 low(1.0), high(-1.0);
    for (int k = 0; k < 8; ++k) {
        const glm::dvec3 corner = glm::mix(box.low, box.high, glm::bvec3(k & 1, k & 2, k & 4));
        const glm::dvec4 clip = clip_from_object * glm::dvec4(corner, 1.0);
        if (!(clip.w > 0.0)) return {{0, 0}, size};
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
    const glm::dvec2 pixels(size);
    const glm::ivec2 from(glm::clamp(glm::floor(pixels * (0.5 + 0.5 * low)) - 1.0, glm::dvec2(0.0), pixels));
    const glm::ivec2 to(glm::clamp(glm::ceil(pixels * (0.5 + 0.5 * high)) + 1.0, glm::dvec2(0.0), pixels));
    return {from, glm::max(to - from, 0)};
}

// Textures whose sides are powers of two are another kind to Mesa, for which it compiles a program anew.
glm::ivec2 smallest_like(glm::ivec2 size) {
    const auto side = [](int pixels) { return std::has_single_bit(static_cast<unsigned>(pixels)) ? 1 : 3; };
    return {side(size.x), side(size.y)};
}

}  // namespace

Tracer::Layer::Layer(glm::ivec2 size, GLenum format) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    const bool floats = format == GL_RGBA32F;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0, floats ? GL_RGBA : GL_RED,
                 floats ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
}

glm::vec2 Tracer::tile() const { return 2.0f * static_cast<float>(kTile) / glm::vec2(size_); }

bool Tracer::ready(const ImplicitSurface& surface) const {
    // All else that the program is made of follows from the formula.
    return program_ && precision_ == precision(surface) && formula_ == surface.glsl(precision_).source;
}

formulas::Precision Tracer::precision(const ImplicitSurface& surface) const {
    return has_doubles_ ? surface.precision() : formulas::Precision::Single;
}

void Tracer::hold(const ImplicitSurface& surface) {
    if (!asked_) has_doubles_ = has_doubles();
    asked_ = true;
    if (ready(surface)) return;
    precision_ = precision(surface);
    program_.emplace(generated(surface, precision_), precision_);
    formula_ = surface.glsl(precision_).source;
}

void Tracer::hold(glm::ivec2 size, std::size_t layers) {
    if (size != size_) {
        layers_.clear();
        size_ = size;
        tile_counts_ = (size + kTile - 1) / kTile;
        tiles_.emplace(tile_counts_, GL_R8);
        nothing_.emplace(smallest_like(size), GL_RGBA32F);
    }
    while (layers_.size() < layers) layers_.emplace_back(size, GL_RGBA32F);
}

void Tracer::fill_tiles() {
    if (!tiles_program_) tiles_program_.emplace();
    glBindFramebuffer(GL_FRAMEBUFFER, tiles_->framebuffer.id());
    glViewport(0, 0, tile_counts_.x, tile_counts_.y);
    const auto set = [](GLfloat value) { glClearBufferfv(GL_COLOR, 0, std::array{value, value, value, value}.data()); };
    glDisable(GL_SCISSOR_TEST);
    set(0.0f);
    glEnable(GL_SCISSOR_TEST);
    const glm::ivec2 first = box_.origin / kTile, end = (box_.origin + box_.size + kTile - 1) / kTile;
    glScissor(first.x, first.y, end.x - first.x, end.y - first.y);
    tiles_program_->use();
    tiles_program_->centres = 0;
    tiles_program_->tile_size = kTile;
    everywhere_.draw();
    glScissor(box_.origin.x, box_.origin.y, box_.size.x, box_.size.y);
}

void Tracer::trace(const ImplicitSurface& surface, const CameraView& view, glm::ivec2 size,
                   const glm::dmat4& object_from_world, std::span<const glm::vec2> shifts) {
    GLint framebuffer = 0;
    std::array<GLint, 4> viewport{}, scissor{};
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glGetIntegerv(GL_SCISSOR_BOX, scissor.data());
    hold(surface);
    hold(size, 1 + shifts.size());

    const bool blend = glIsEnabled(GL_BLEND);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, size.x, size.y);
    box_ = box_in_picture(*surface.region(), view, size, object_from_world);
    // Tiles hold pixels beside the box, too, and edges are looked for there: an earlier picture must not remain in them.
    constexpr int kBeside = kTile + 1;
    glScissor(box_.origin.x - kBeside, box_.origin.y - kBeside, box_.size.x + 2 * kBeside, box_.size.y + 2 * kBeside);
    program_->use();
    program_->space_from_clip = glm::mat4(object_from_world * glm::inverse(view.clip_from_world()));
    program_->ray_depth = static_cast<float>(view.ray_depth());
    const glm::dvec4 eye = object_from_world * glm::dvec4(view.eye().xyz, 1.0);
    program_->eye = glm::vec3(glm::dvec3(eye) / eye.w);
    program_->box_low = glm::vec3(surface.region()->low);
    program_->box_high = glm::vec3(surface.region()->high);
    program_->ball = surface.source().clip == Clip::Ball ? static_cast<float>(surface.ball()) : 0.0f;
    program_->centres = 0;
    program_->tiles = 1;
    for (std::size_t k = 0; k < program_->parameters.size(); ++k)
        program_->parameters[k] = static_cast<float>(surface.source().parameters[k]);

    // The first pass reads nothing, but textures of another kind would make the driver compile the program twice.
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, tiles_->texture.id());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, nothing_->texture.id());
    glBindFramebuffer(GL_FRAMEBUFFER, layers_[0].framebuffer.id());
    // What replaces everything blends as well, as far as Mesa knows: it would compile the program a second time for tiles
    // that are wholly covered.
    if (blends_floats()) glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    program_->only_edges = 0.0f;
    program_->shift = glm::vec2(0.0f);
    program_->tile = glm::vec2(0.0f);
    everywhere_.draw();

    glBindTexture(GL_TEXTURE_2D, layers_[0].texture.id());
    fill_tiles();
    glViewport(0, 0, size.x, size.y);
    program_->use();
    program_->only_edges = 1.0f;
    program_->tile = tile();
    program_->least = kNoEdge;
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        glBindFramebuffer(GL_FRAMEBUFFER, layers_[1 + k].framebuffer.id());
        program_->shift = 2.0f * shifts[k] / glm::vec2(size);
        draw_tiles();
    }

    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    blend ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    glScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
}

}  // namespace normalscope
