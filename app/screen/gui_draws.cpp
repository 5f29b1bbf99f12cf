#include "screen/gui_draws.h"

#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>  // ImRect

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace normalscope {

namespace {

ImRect rect_of(const PixelRect& box) {
    const glm::vec2 low(box.origin), high(box.origin + box.size);
    return {low.x, low.y, high.x, high.y};
}

ImRect common(ImRect a, const ImRect& b) {
    a.ClipWithFull(b);
    return a;
}

struct DeleteList {
    void operator()(ImDrawList* list) const { IM_DELETE(list); }
};

template <class T>
void mix(std::size_t& hash, const T* first, std::size_t count) {
    const std::string_view bytes(reinterpret_cast<const char*>(first), count * sizeof(T));
    hash = (hash ^ std::hash<std::string_view>()(bytes)) * 0x9e3779b1u + 1;
}

// What one command draws with.
struct Drawn {
    std::span<const ImDrawIdx> corners;
    std::span<const ImDrawVert> vertices;  // from the first to the last that is a corner
    ImRect bounds;                         // of all pixels that it reaches
};

Drawn drawn_by(const ImDrawList& list, const ImDrawCmd& command) {
    const std::span corners(list.IdxBuffer.Data + command.IdxOffset, command.ElemCount);
    const auto [first, last] = std::ranges::minmax(corners);
    const std::span vertices(list.VtxBuffer.Data + command.VtxOffset + first, last - first + 1u);
    ImRect reach(vertices.front().pos, vertices.front().pos);
    for (const ImDrawVert& vertex : vertices) reach.Add(vertex.pos);
    return {corners, vertices, common(reach, ImRect(command.ClipRect))};
}

}  // namespace

void draw_all(ImDrawData& round) { ImGui_ImplOpenGL3_RenderDrawData(&round); }

void draw_within(const ImDrawData& round, const PixelRect& box) {
    std::vector<std::unique_ptr<ImDrawList, DeleteList>> lists;
    for (const ImDrawList* list : round.CmdLists) {
        const auto reaches = [&](const ImDrawCmd& command) { return rect_of(box).Overlaps(ImRect(command.ClipRect)); };
        if (std::any_of(list->CmdBuffer.begin(), list->CmdBuffer.end(), reaches))
            lists.emplace_back(list->CloneOutput());
    }
    ImDrawData within = round;
    within.CmdLists.resize(0);
    for (const auto& list : lists) {
        for (ImDrawCmd& command : list->CmdBuffer)
            command.ClipRect = common(rect_of(box), ImRect(command.ClipRect)).ToVec4();
        within.CmdLists.push_back(list.get());
    }
    within.CmdListsCount = within.CmdLists.Size;
    draw_all(within);
}

std::size_t hash_around(const ImDrawData& round, const PixelRect& box) {
    std::size_t hash = 0;
    for (const ImDrawList* list : round.CmdLists)
        for (const ImDrawCmd& command : list->CmdBuffer) {
            if (command.ElemCount == 0) continue;
            const Drawn drawn = drawn_by(*list, command);
            if (rect_of(box).Contains(drawn.bounds)) continue;
            mix(hash, &command.ClipRect, 1);
            mix(hash, &command.TextureId, 1);
            mix(hash, drawn.corners.data(), drawn.corners.size());
            mix(hash, drawn.vertices.data(), drawn.vertices.size());
        }
    return hash;
}

}  // namespace normalscope
