// One triangle over the whole pane; each corner carries the ray through it.
#include "ground.glsl"

layout(location = 0) in vec2 corner;  // in clip space

uniform mat4 world_from_clip;
uniform float ray_depth;  // in clip space, where each ray is looked up
uniform vec3 top_color;
uniform vec3 bottom_color;
uniform Ground all_ground;

out vec3 ray;
out vec3 sky;
flat out Ground ground;

void main() {
    ground = all_ground;
    vec4 far = world_from_clip * vec4(corner, ray_depth, 1.0);
    ray = far.xyz / far.w - all_ground.eye;
    sky = mix(bottom_color, top_color, 0.5 * corner.y + 0.5);
    gl_Position = vec4(corner, 1.0, 1.0);
}
