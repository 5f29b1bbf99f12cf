#include "ui/panel/panel.h"

#include "core/base/error.h"
#include "core/base/overload.h"
#include "core/mesh/mesh_file.h"
#include "core/scene/scene_fields.h"
#include "core/scene/scene_json.h"
#include "ui/kit/number_bar.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panel_memory.h"

#include <cctype>
#include <filesystem>
#include <string>

namespace normalscope {

namespace {

std::string label(Shape shape) {
    std::string text(name(shape));
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

// What the surface is, in a word or two.
std::string current_name(const SurfaceSource& surface) {
    return std::visit(Overload{[](const ShapeSurface& s) { return label(s.shape); },
                               [](const MeshSurface& m) { return std::filesystem::path(m.mesh).filename().string(); },
                               [](const FormulaSurface&) { return std::string("Formula"); }},
                      surface);
}

void shape_picker(Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    const ShapeSurface* shape = std::get_if<ShapeSurface>(&scene.surface);
    const MeshSurface* mesh = std::get_if<MeshSurface>(&scene.surface);
    const bool formula = std::holds_alternative<FormulaSurface>(scene.surface);
    const float open_width = look.px(96), gallery_width = look.px(76), gap = look.px(8);
    const float width = ImGui::GetContentRegionAvail().x - open_width - gallery_width - 2 * gap;
    const std::string current = current_name(scene.surface);
    if (begin_combo(look, "##shape", current, width)) {
        for (const auto& [each, ignored] : kShapeNames) {
            const bool chosen = shape && shape->shape == each;
            if (ImGui::Selectable(label(each).c_str(), chosen)) {
                scene.surface = ShapeSurface{each, shape ? shape->resolution : ShapeSurface{}.resolution};
                context.requests.make_room = true;
            }
            if (chosen) ImGui::SetItemDefaultFocus();
        }
        if (ImGui::Selectable("Formula…", formula) && !formula) {
            scene.surface = memory.formula.last;
            memory.formula.focus = context.requests.make_room = true;
        }
        ImGui::EndCombo();
    } else {
        tip(look, mesh      ? mesh->mesh.c_str()
                  : formula ? "f(x, y, z) = 0, with ∇f for its normal."
                            : "A shape with exact normals.");
    }
    ImGui::SameLine(0, gap);
    ImGui::PushStyleColor(ImGuiCol_Button, memory.gallery.open ? look.line : look.field);
    const bool toggled = ImGui::Button("Gallery", {gallery_width, 0});
    ImGui::PopStyleColor();
    if (toggled) memory.gallery.toggle();
    tip(look, "Surfaces by formula, with their pictures.");
    ImGui::SameLine(0, gap);
    if (ImGui::Button("Mesh file…", {open_width, 0})) context.dialog.open(FileDialog::For::OpenMesh);
    tip(look, ("Take the surface from a mesh file (" + mesh_endings_in_words() + "); everything else stays as it is.")
                  .c_str());
}

// Why a formula's surface is drawn by triangles; empty where it is met by rays.
std::string_view why_triangles(const Scene& scene) {
    if (!std::holds_alternative<FormulaSurface>(scene.surface)) return {};
    try {
        const Transform<World, Object> m = world_from_object(scene);
        if (!m.inverse())
            return "M has no inverse, so no ray can be taken to object space: these triangles are drawn instead.";
        if (!m.affine())
            return "M is not affine, and a ray may pass through infinity: these triangles are drawn instead.";
    } catch (const InputError&) {  // said elsewhere
        return {};
    }
    return {};
}

void wrapped_line(std::string_view text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

}  // namespace

void surface_section(Scene& scene, PanelMemory& memory, const PanelContext& context) {
    const Look& look = context.look;
    if (memory.formula.focus || memory.gallery.wanted) ImGui::GetStateStorage()->SetBool(ImGui::GetID("Surface"), true);
    if (!section(look, "Surface")) return;
    shape_picker(scene, memory, context);
    gallery(scene, memory.gallery, context);
    formula_section(scene, memory.formula, context);
    if (ShapeSurface* shape = std::get_if<ShapeSurface>(&scene.surface)) {
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
        number_bar(look, "##resolution", shape->resolution,
                   {.letter = "resolution",
                    .low = 3,
                    .high = 128,
                    .zero = 3,
                    .range = {3, 512},
                    .about = "Segments around the shape, 3 to 512.",
                    .rest = ShapeSurface{}.resolution});
    }
    if (!context.frame.surface) return;
    const Mesh& mesh = context.frame.surface->mesh;
    ImGui::PushFont(look.fonts.small);
    dim_text(look, grouped(mesh.triangles.size()) + " triangles, " + grouped(mesh.face_count()) + " faces, " +
                       grouped(mesh.positions.size()) + " vertices");
    if (!std::holds_alternative<FormulaSurface>(scene.surface))
        for (const std::string& note : mesh.notes) wrapped_line(note);
    if (const std::string_view why = why_triangles(scene); !why.empty()) wrapped_line(why);
    ImGui::PopFont();
}

}  // namespace normalscope
