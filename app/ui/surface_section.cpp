#include "ui/panel.h"

#include "ui/numbers.h"
#include "ui/widgets.h"

#include <array>
#include <filesystem>
#include <string>

namespace normalscope {

namespace {

constexpr std::array<const char*, 7> kShapes{"Sphere", "Cube", "Cylinder", "Cone", "Torus", "Plane", "Dodecahedron"};

void shape_picker(const Look& look, Scene& scene, const PanelContext& context) {
    ShapeSurface* shape = std::get_if<ShapeSurface>(&scene.surface);
    const MeshSurface* mesh = std::get_if<MeshSurface>(&scene.surface);
    const float open_width = look.px(104), gap = look.px(8),
                width = ImGui::GetContentRegionAvail().x - open_width - gap;
    const std::string current = shape ? kShapes.at(static_cast<std::size_t>(shape->shape))
                                      : std::filesystem::path(mesh->mesh).filename().string();
    if (begin_combo(look, "##shape", current, width)) {
        for (std::size_t i = 0; i < kShapes.size(); ++i) {
            const bool chosen = shape && shape->shape == static_cast<Shape>(i);
            if (ImGui::Selectable(kShapes[i], chosen))
                scene.surface =
                    ShapeSurface{static_cast<Shape>(i), shape ? shape->resolution : ShapeSurface{}.resolution};
            if (chosen) ImGui::SetItemDefaultFocus();
        }
        ImGui::EndCombo();
    } else {
        tip(look, mesh ? mesh->mesh.c_str() : "A shape with exact normals.");
    }
    ImGui::SameLine(0, gap);
    if (ImGui::Button("Mesh file…", {open_width, 0})) context.dialog.open(FileDialog::For::OpenMesh);
    tip(look, "Take the surface from a mesh file (.obj, .ply, .stl); everything else stays as it is.");
}

}  // namespace

void surface_section(Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    if (!section(look, "Surface")) return;
    shape_picker(look, scene, context);
    if (ShapeSurface* shape = std::get_if<ShapeSurface>(&scene.surface)) {
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
        number_bar(look, "##resolution", shape->resolution,
                   {.letter = "resolution",
                    .low = 3,
                    .high = 128,
                    .zero = 3,
                    .range = {3, 512},
                    .about = "Segments around the shape, 3 to 512."});
    }
    if (!context.frame.surface) return;
    const Mesh& mesh = context.frame.surface->mesh;
    ImGui::PushFont(look.fonts.small);
    dim_text(look, grouped(mesh.triangles.size()) + " triangles, " + grouped(mesh.face_count()) + " faces, " +
                       grouped(mesh.positions.size()) + " vertices");
    if (!mesh.note.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(mesh.note.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::PopFont();
}

}  // namespace normalscope
