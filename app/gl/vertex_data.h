#pragma once

#include "core/frame/solids.h"
#include "core/mesh/mesh.h"
#include "gl/objects.h"

#include <cstddef>
#include <optional>
#include <span>

namespace normalscope {

// Vertex arrays and the buffers behind them; the attribute numbers are those in the shaders. What scene.vert draws has
// one layout, used or not: a software driver compiles the shader anew for each layout.

/// A triangle over the whole pane.
class PaneVertices {
public:
    PaneVertices();
    void draw() const;

private:
    GlVertexArray array_;
    GlBuffer corners_;
};

/// A square from (0, 0) to (1, 1), as often as there are tiles in a pane.
class TileVertices {
public:
    TileVertices();
    void draw(int count) const;

private:
    GlVertexArray array_;
    GlBuffer corners_;
};

/// A mesh that stays on the GPU.
class MeshVertices {
public:
    explicit MeshVertices(const Mesh& mesh);
    void draw() const;

private:
    GlVertexArray array_;
    GlBuffer vertices_, no_sites_, indices_;
    GLsizei index_count_ = 0;
};

/// One arrow's shape, drawn at every site.
class ArrowVertices {
public:
    ArrowVertices(std::span<const Site> sites, ArrowLook look);
    void draw() const;

private:
    GlVertexArray array_;
    GlBuffer shape_, sites_;
    GLsizei shape_count_ = 0, site_count_ = 0;
};

/// Triangles that change every frame.
class SolidVertices {
public:
    SolidVertices();
    void draw(const Solids& solids);

private:
    GlVertexArray array_;
    GlBuffer vertices_, no_sites_;
};

}  // namespace normalscope
