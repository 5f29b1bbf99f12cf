#pragma once

#include "core/base/beside.h"
#include "core/frame/frame.h"
#include "core/picture/site_clusters.h"
#include "gl/objects.h"
#include "gl/programs.h"

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace normalscope {

/// So many arrows that each is small: outlines turned to the eye in place of solids. Where there are so many that most are
/// hidden by others, they are drawn from front to back in clusters, of which those are left out that nothing would be seen
/// of. The picture is as if all had been drawn.
class ArrowField {
public:
    /// The fewest.
    static constexpr std::size_t kFrom = 500;

    /// The sites must outlive this.
    explicit ArrowField(std::span<const Site> sites);
    /// With `program` in use and everything set, for the arrows as `draw` has them.
    void draw(const SceneProgram& program, const ArrowDraw& draw, const CameraView& view);
    bool has_heads() const;

private:
    struct Part;
    /// All arrows in one look.
    struct Kind {
        GlVertexArray array;
        GlBuffer shapes, sites, corners;
        GLsizei shape_vertices = 0, shape_corners = 0;  ///< of each
    };
    const SiteClusters& in_clusters();
    const Kind& kind(ArrowLook look);
    std::vector<Part> front_to_back(const ArrowDraw& draw, const CameraView& view);
    static void draw_parts(const Kind& kind, std::span<const Part> parts);
    void find_hidden(std::span<Part> parts, const CameraView& view);

    std::span<const Site> sites_;
    Beside<SiteClusters> clustering_;
    SiteClusters in_clusters_;         // once that is ready
    std::map<ArrowLook, Kind> kinds_;  // made when first wanted
    GlVertexArray box_array_;
    GlBuffer boxes_;
    BoxProgram box_program_;
    std::vector<GlQuery> queries_;
};

}  // namespace normalscope
