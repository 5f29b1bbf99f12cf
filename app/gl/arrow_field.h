#pragma once

#include "core/frame/frame.h"
#include "core/picture/site_clusters.h"
#include "gl/objects.h"
#include "gl/programs.h"

#include <span>
#include <vector>

namespace normalscope {

/// So many arrows that each is a few pixels and most are hidden by others: of few triangles, and drawn from front to back
/// in clusters, of which those are left out that nothing would be seen of. The picture is as if all had been drawn.
class ArrowField {
public:
    explicit ArrowField(std::span<const Site> sites);
    /// With `program` in use and everything set, for the arrows as `draw` has them.
    void draw(const SceneProgram& program, const ArrowDraw& draw, const CameraView& view);
    bool has_heads() const { return corners_ > 3; }

private:
    struct Part;
    std::vector<Part> front_to_back(const ArrowDraw& draw, const CameraView& view) const;
    void draw_parts(std::span<const Part> parts) const;
    void find_hidden(std::span<Part> parts, const CameraView& view);

    std::size_t site_count_;
    std::vector<SiteCluster> clusters_;
    GLsizei corners_;  ///< of an arrow
    GlVertexArray array_, box_array_;
    GlBuffer shapes_, sites_, boxes_;
    BoxProgram box_program_;
    std::vector<GlQuery> queries_;
};

}  // namespace normalscope
