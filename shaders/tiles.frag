// What each tile of a traced picture holds: nothing, a surface, or an edge of one. All that is done for each sample is
// done at edges only.
#include "edges.glsl"

uniform sampler2D centres;  // what trace.frag wrote for the pixels' centres
uniform int tile_size;      // in pixels

out vec4 tile;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * tile_size, last = textureSize(centres, 0) - 1;
    float found = 0.0;
    // From a pixel before the tile: an edge lies on both its sides.
    for (int y = -1; y < tile_size; ++y)
        for (int x = -1; x < tile_size; ++x) {
            ivec2 at = clamp(first + ivec2(x, y), ivec2(0), last);
            vec4 here = texelFetch(centres, at, 0);
            bool edge = differ(here, texelFetch(centres, min(at + ivec2(1, 0), last), 0)) ||
                        differ(here, texelFetch(centres, min(at + ivec2(0, 1), last), 0));
            found = max(found, edge ? 1.0 : here.w > 0.0 ? 0.5 : 0.0);
        }
    tile = vec4(found);
}
