#pragma once

#include "core/frame/frame.h"
#include "gl/arrow_field.h"
#include "gl/programs.h"
#include "gl/target.h"
#include "gl/tracer.h"
#include "gl/vertex_data.h"

#include <glm/vec2.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// What lives on the GPU: programs and vertices, of which the surface's are kept until another surface comes.
struct Resources {
    std::map<std::string, BackdropProgram> backdrop_programs;  // by what they define; compiled when first wanted
    SceneProgram scene_program;
    std::optional<SceneProgram> arrow_field_program;
    std::map<std::string, SurfaceProgram> surface_programs;  // by what they define; compiled when first wanted
    std::map<std::string, TracedProgram> traced_programs;
    std::optional<Tracer> tracer;
    int draft_coarseness = 2;
    PaneVertices backdrop;
    bool first_picture = true;
    SolidVertices solids;

    std::shared_ptr<const Surface> surface;
    std::optional<MeshVertices> mesh;
    std::map<ArrowLook, ArrowVertices> arrows;  // made when first wanted
    std::optional<ArrowField> arrow_field;      // in place of those, where there are many
    std::optional<glm::vec2> only_sample;       // the one that is drawn now, from the pixel's centre; none: all at once

    void hold(const std::shared_ptr<const Surface>& wanted) {
        if (surface == wanted) return;
        arrows.clear();
        arrow_field.reset();
        if (wanted->arrows.size() >= ArrowField::kFrom) arrow_field.emplace(wanted->arrows);
        mesh.emplace(wanted->mesh);
        surface = wanted;
    }

    /// And over it the target's samples, if there are any.
    void draw_backdrop(const Frame& frame, const Pane& pane, const Target& target);
    void draw_pane(const Frame& frame, const Pane& pane);
    void draw_surface(const Frame& frame, const Pane& pane, const SurfaceDraw& draw);
    void draw_traced(const Frame& frame, const Pane& pane, const SurfaceDraw& draw);
    void draw_arrows(const Frame& frame, const Pane& pane);
    void draw_solids(const Frame& frame, const Pane& pane, const std::vector<SolidVertex>& vertices);

private:
    // Of its distance from the eye: more than facets and rounding make of one place.
    static constexpr double kYields = 6e-4;
    void begin(const SceneProgram& program, const Frame& frame, const Pane& pane) const;
    /// What it makes of the middle of a pixel is seen at the sample that is drawn now.
    glm::mat4 seen(const Pane& pane, const glm::dmat4& clip_from_world) const;
    static void set_normals(const SceneProgram& program, const NormalMap& normals);
    void set_look(const SceneProgram& program, const Pane& pane, const SurfaceDraw& draw) const;
    static void set_error_maps(const SurfaceProgram& program, const Frame& frame);
};

}  // namespace normalscope
