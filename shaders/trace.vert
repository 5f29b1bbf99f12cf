// The whole pane, or those of its tiles that hold something; each corner carries the ray through it.
layout(location = 0) in vec2 corner;  // in clip space; of a tile: from (0, 0) to (1, 1)

uniform mat4 space_from_clip;  // object space to trace in, world space to light in
uniform vec3 eye;              // in that space
uniform float ray_depth;       // in clip space, where each ray is looked up
uniform vec2 shift;            // from the pixel's centre to one of its samples, in clip space
uniform vec2 tile;             // a tile's size in clip space; 0: the whole pane
uniform sampler2D tiles;       // what tiles.frag wrote
uniform float least;           // tiles with less are left out

flat out float holds;  // what the tile does
out vec3 ray;  // of no particular length: t along it is the same in both spaces

void main() {
    vec2 at = corner;
    holds = 1.0;
    if (tile.x > 0.0) {
        int columns = textureSize(tiles, 0).x;
        ivec2 place = ivec2(gl_InstanceID % columns, gl_InstanceID / columns);
        holds = texelFetch(tiles, place, 0).r;
        at = min((vec2(place) + corner) * tile - 1.0, 1.0);
    }
    vec4 far = space_from_clip * vec4(at + shift, ray_depth, 1.0);
    ray = far.xyz / far.w - eye;
    gl_Position = holds > least ? vec4(at, 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}
