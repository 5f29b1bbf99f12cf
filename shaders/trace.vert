// The whole pane, or those of its tiles that hold something; each corner carries the ray through it.
layout(location = 0) in vec2 corner;  // in clip space; of a tile: from (0, 0) to (1, 1)

uniform mat4 space_from_clip;  // object space to trace in, world space to light in
#ifndef CARRIES
uniform vec3 eye;              // in that space
#endif
uniform float ray_depth;       // in clip space, where each ray is looked up
uniform vec2 shift;            // from the pixel's centre to one of its samples, in clip space
uniform vec2 tile;             // a tile's size in clip space; 0: the whole pane
uniform sampler2D tiles;       // what tiles.frag wrote
uniform float least;           // tiles with less are left out

flat out float holds;  // what the tile does
out vec3 ray;  // of no particular length: t along it is the same in both spaces

#ifdef CARRIES
// What is the same for all pixels comes to them as what a triangle carries: Mesa's software driver fetches each number of a
// uniform for every pixel anew.
uniform mat4 carried_clip_from_world;   flat out mat4 clip_from_world;
uniform mat4 carried_normal_matrix;     flat out mat4 normal_matrix;
uniform float carried_normal_w;         flat out float normal_w;
uniform float carried_unit_at_vertices; flat out float unit_at_vertices;
uniform vec4 carried_tint;              flat out vec4 tint;
uniform mat3 carried_object_from_world; flat out mat3 object_from_world;
uniform float carried_mirrored;         flat out float mirrored;
uniform vec3 carried_toward_light;      flat out vec3 toward_light;
uniform vec3 carried_eye;               flat out vec3 eye;
uniform vec3 carried_inside_color;      flat out vec3 inside_color;
uniform float carried_outside;          flat out float outside;
uniform float carried_color_coded;      flat out float color_coded;
uniform float carried_unit_at_pixels;   flat out float unit_at_pixels;
uniform float carried_zero_is_black;    flat out float zero_is_black;
uniform float carried_ghost;            flat out float ghost;
uniform float carried_leave_edges;      flat out float leave_edges;
uniform ivec2 carried_pane_origin;      flat out ivec2 pane_origin;
uniform int carried_coarseness;         flat out int coarseness;

void carry() {
    clip_from_world = carried_clip_from_world;
    normal_matrix = carried_normal_matrix;
    normal_w = carried_normal_w;
    unit_at_vertices = carried_unit_at_vertices;
    tint = carried_tint;
    object_from_world = carried_object_from_world;
    mirrored = carried_mirrored;
    toward_light = carried_toward_light;
    eye = carried_eye;
    inside_color = carried_inside_color;
    outside = carried_outside;
    color_coded = carried_color_coded;
    unit_at_pixels = carried_unit_at_pixels;
    zero_is_black = carried_zero_is_black;
    ghost = carried_ghost;
    leave_edges = carried_leave_edges;
    pane_origin = carried_pane_origin;
    coarseness = carried_coarseness;
}
#endif

void main() {
#ifdef CARRIES
    carry();
#endif
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
