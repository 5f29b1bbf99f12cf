// Light on whatever normal it is given: a wrong normal shows as wrong light.
#ifdef LIT_AT_VERTICES
in vec3 vertex_color;

out vec4 color;

void main() { color = vec4(vertex_color, 1.0); }
#else
#include "light.glsl"

#ifdef CARRIES  // see trace.vert
#define SHARED flat in
#else
#define SHARED uniform
#endif

#ifdef TRACED
in vec3 ray;              // in world space
flat in float holds;      // what the tile does

SHARED mat4 clip_from_world;
SHARED mat4 normal_matrix;  // as in scene.vert
SHARED float normal_w;
SHARED float unit_at_vertices;
SHARED vec4 tint;
SHARED mat3 object_from_world;
SHARED float mirrored;    // 1: M reflects
SHARED ivec2 pane_origin;
SHARED int coarseness;    // pixels a side of each texel of `hits`
SHARED float leave_edges;  // 1: not where those are
uniform sampler2D hits;   // what trace.frag wrote: unit n_object, t
uniform sampler2D edges;  // the same for the first sample, with pixels left out that are no edges; counts where a tile holds one
#ifdef GL_OES_sample_variables
uniform int sample_mask;  // the samples that are drawn to; elsewhere GL has a state for that
#endif
#else
#ifdef PROJECTIVE
in vec4 world_place;
#else
in vec3 world_position;
#endif
in vec3 world_normal;
in vec4 base_color;
#ifdef ERROR_MAP
in vec3 object_normal;
in vec3 object_position;
#endif
#endif

SHARED vec3 toward_light;
SHARED vec3 eye;
SHARED float outside;         // +1 or -1: the winding that the normals take for outside; 0: no side is the inside
SHARED float color_coded;     // 1: an arrow or mark, whose colour is its meaning
SHARED vec3 inside_color;
SHARED float unit_at_pixels;  // 1: make interpolated normals of unit length again, as one should
SHARED float zero_is_black;   // 1: show a normal of length zero as the NaN that it would become
#ifdef GHOST
const float ghost = 1.0;
#else
SHARED float ghost;           // 1: a glassy shell, clearest where one looks straight through
#endif
#ifdef ERROR_MAP
uniform mat4 naive_matrix;
uniform float naive_w;
uniform mat3 inverse_transpose_matrix;
uniform mat4 planes;  // (M⁻¹)ᵀ, by which tangent planes go; where M is not affine
uniform vec3 ramp[6];
#endif

out vec4 color;  // times alpha

#ifdef ERROR_MAP
vec3 error_color(vec3 object_normal) {
    vec3 naive = (naive_matrix * vec4(object_normal, naive_w)).xyz;
#ifdef PROJECTIVE
    vec3 correct = (planes * vec4(object_normal, -dot(object_normal, object_position))).xyz;
#else
    vec3 correct = inverse_transpose_matrix * object_normal;
#endif
    float at = atan(length(cross(naive, correct)), dot(naive, correct)) / 1.5707963 * 5.0;
    vec3 c = ramp[0];
    for (int i = 0; i < 5; ++i) c = mix(c, ramp[i + 1], clamp(at - float(i), 0.0, 1.0));
    return c;
}
#endif

void main() {
#ifdef TRACED
#ifdef GL_OES_sample_variables
    gl_SampleMask[0] = sample_mask;
#endif
    ivec2 pixel = (ivec2(gl_FragCoord.xy) - pane_origin) / coarseness;
    vec4 hit = texelFetch(hits, pixel, 0);
    bool edge = holds > 0.75 && texelFetch(edges, pixel, 0).w >= 0.0;
    if (hit.w <= 0.0 || (leave_edges > 0.5 && edge)) discard;
    vec3 world_position = eye + hit.w * ray;
    vec4 clip = clip_from_world * vec4(world_position, 1.0);
    gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
    vec3 object_normal = hit.xyz;
    vec4 sent = normal_matrix * vec4(object_normal, normal_w);
    float unit = unit_at_vertices < 0.5 ? 1.0 : unit_at_vertices < 1.5 ? length(sent.xyz) : length(sent);
    vec3 world_normal = unit > 0.0 ? sent.xyz / unit : sent.xyz;
    vec4 base_color = tint;
    bool front_facing = dot(object_normal, object_from_world * ray) < 0.0 != mirrored > 0.5;
#else
    bool front_facing = gl_FrontFacing;
#ifdef PROJECTIVE
    if (world_place.w <= 0.0) discard;  // beyond infinity
    vec3 world_position = world_place.xyz / world_place.w;
#endif
#endif
#ifdef ERROR_MAP
    vec3 base = error_color(object_normal);
#else
    vec3 base = base_color.rgb;
#endif
    float size = length(world_normal);
#ifdef NORMALS
    vec3 shown = unit_at_pixels > 0.5 && size > 0.0 ? world_normal / size : world_normal;
    if (outside != 0.0 && front_facing == (outside < 0.0)) shown = -shown;
    color = vec4(clamp(0.5 * shown + 0.5, 0.0, 1.0), 1.0) * base_color.a;  // numbers, not light: as they are
    return;
#endif
    if (size == 0.0) {  // no normal, no light: flat colour says so
        color = vec4(base * (1.0 - zero_is_black), 1.0) * base_color.a;
        return;
    }
    vec3 n = unit_at_pixels > 0.5 ? world_normal / size : world_normal;
    bool seen_from_inside = outside != 0.0 && front_facing == (outside < 0.0);
    if (seen_from_inside) {
        n = -n;
        base = inside_color;
    }
    vec3 view = normalize(eye - world_position);
    vec3 c = lit(base, n, view, toward_light, color_coded > 0.5);
    float alpha = base_color.a;
    if (ghost > 0.5) {
        float rim = 1.0 - abs(dot(n, view));
        alpha *= 0.2 + 0.8 * rim * rim;
        c = to_light(base);
    }
    color = vec4(to_srgb(c), 1.0) * alpha;
}
#endif
