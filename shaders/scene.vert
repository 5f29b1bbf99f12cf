// Everything solid: the mesh, triangles that are in world space already (world_from_object = 1), and instanced arrows.
// One program for all three, since a software driver compiles each anew: that is most of what a cold capture waits for.
layout(location = 0) in vec3 position;     // of an arrow: around its axis, in shaft radii; 0 … 1 … 2, base, neck and tip, along it
layout(location = 1) in vec3 normal;       // of an arrow: in the same frame
layout(location = 2) in vec4 own_color;    // sRGB; of an arrow: alpha 1 where its head is hollow, and where it is lit here, in red by how much
layout(location = 3) in vec3 site_point;   // of an arrow: the surface's point and normal there, in object space
layout(location = 4) in vec3 site_normal;

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform mat4 world_from_object;
uniform mat4 normal_matrix;      // to world space: the first three numbers of normal_matrix * (n, normal_w),
uniform float normal_w;
uniform float unit_at_pixels;
uniform float unit_at_vertices;  // made of unit length here: 0 not, 1 without w, 2 with it
uniform float arrow_length;  // 0: no arrow
uniform float shaft_radius;
uniform float head_length;
uniform vec4 cleared;        // a ball in world space, in which no arrow stands
uniform vec4 tint;           // sRGB; alpha 0: each vertex has its own colour
uniform vec3 paper;          // what is seen within a hollow head

#ifdef LIT_AT_VERTICES
#include "light.glsl"

uniform vec3 toward_light;

out vec3 vertex_color;
#else
#ifdef PROJECTIVE
out vec4 world_place;  // not yet divided by its w, which is not the same at all corners
#else
out vec3 world_position;
#endif
out vec3 world_normal;
out vec4 base_color;
#endif
#ifdef ERROR_MAP
out vec3 object_normal;
out vec3 object_position;
#endif

void main() {
    bool arrow = arrow_length > 0.0;
    vec4 world = world_from_object * vec4(arrow ? site_point : position, 1.0);
    vec4 sent = normal_matrix * vec4(arrow ? site_normal : normal, normal_w);
    vec3 direction = sent.xyz;
    float unit = unit_at_vertices < 0.5 ? 1.0 : unit_at_vertices < 1.5 ? length(direction) : length(sent);
    if (unit > 0.0) direction /= unit;
    if (arrow) {
        // Base and direction go to world space by the matrices of the arrow's kind: dragging the object uploads nothing.
        float size = world.w > 0.0 ? length(direction) : 0.0;  // what has no image has no arrow
        vec3 axis = size > 0.0 ? direction / size : vec3(0.0, 0.0, 1.0);
        world = vec4(world.xyz / (world.w > 0.0 ? world.w : 1.0), 1.0);
        if (distance(world.xyz, cleared.xyz) < cleared.w) size = 0.0;
        vec3 to_eye = eye - world.xyz, u = cross(to_eye, axis);  // so that v points to the eye, as far as it can
        if (dot(u, u) < 1e-11 * dot(to_eye, to_eye)) u = cross(abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), axis);
        u = normalize(u);
        vec3 v = cross(axis, u);
        float y = position.y;
#ifdef LIT_AT_VERTICES
        // One triangle in place of a cone leans so that its base and its tip lie apart, seen from behind as from in front.
        if (own_color.g > 0.5 && dot(to_eye, axis) < 0.0) y = -y;
#endif
        // 0 base, 1 neck, 2 tip
        float neck = arrow_length - head_length;
        float along = position.z <= 1.0 ? position.z * neck : position.z < 2.0 ? neck + (position.z - 1.0) * head_length : arrow_length;
        // Normals that are left as long as they come out show it.
        if (unit_at_vertices != 1.0 && unit_at_pixels < 0.5) along *= min(size, 3.0);
        vec3 offset = along * axis + shaft_radius * (position.x * u + y * v);
        world.xyz += size > 0.0 ? offset : vec3(0.0);  // no direction, no arrow
        direction = normal.x * u + normal.y * v + normal.z * axis;
    }
#ifdef LIT_AT_VERTICES
    float size = length(direction);
    vec3 n = size > 0.0 ? direction / size : vec3(0.0);
    vec3 base = own_color.a > 0.5 ? paper : tint.rgb;
    vertex_color = to_srgb(own_color.r * lit(base, n, normalize(eye - world.xyz), toward_light, true));
#else
#ifdef PROJECTIVE
    world_place = world;
#else
    world_position = world.xyz;
#endif
    world_normal = direction;
    base_color = tint.a > 0.0 ? tint : own_color;
    if (arrow && own_color.a > 0.5) base_color.rgb = paper;
#endif
#ifdef ERROR_MAP
    object_normal = normal;
    object_position = position;
#endif
    gl_Position = clip_from_world * world;
}
