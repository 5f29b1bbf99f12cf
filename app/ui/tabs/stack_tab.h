#pragma once

#include "core/explain/stack_algebra.h"
#include "core/math/polar_decomposition.h"
#include "ui/kit/side_panel.h"
#include "ui/tabs/stack_player.h"

#include <glm/mat3x3.hpp>

#include <optional>
#include <vector>

namespace normalscope {

/// What the tab remembers: what it has computed, until what it was computed from changes, and what is unfolded.
struct StackTab {
    StackPlayer player;

    std::optional<std::vector<StackEntry>> algebra_of;
    std::vector<EntryAlgebra> algebra;
    struct Row {
        bool open = false;
        float height = 0.0f;  ///< as last drawn; 0: not yet
    };
    std::vector<Row> rows;

    std::optional<std::vector<StackEntry>> orders_of;
    std::optional<Probe> orders_at;
    std::vector<OrderOfInverses> orders;
    bool orders_commute = false;

    std::optional<glm::dmat3> decomposition_of;
    int decomposition_rank = 3;
    Decomposition decomposition;
};

void draw_stack_tab(Scene& scene, StackTab& tab, const SideContext& context);

// Its sections.
void stack_entries(const Look& look, const Scene& scene, StackTab& tab);
void stack_products(const Look& look, const Scene& scene, StackTab& tab);
void wrong_orders(const Look& look, Scene& scene, StackTab& tab, const Frame& frame);
void rotation_and_stretch(const Look& look, Scene& scene, StackTab& tab);

}  // namespace normalscope
