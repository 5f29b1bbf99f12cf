// One triangle over the whole pane; each corner carries the ray through it.
layout(location = 0) in vec2 corner;  // in clip space

uniform mat4 world_from_clip;
uniform float ray_depth;  // in clip space, where each ray is looked up
uniform vec3 top_color;
uniform vec3 bottom_color;

out vec3 sky;
#ifndef SKY
out vec3 ray;
// As trace.vert does.
uniform vec3 carried_eye;          flat out vec3 eye;
uniform vec3 carried_grid_color;   flat out vec3 grid_color;
uniform float carried_ground;      flat out float ground;
uniform float carried_unit;        flat out float unit;
uniform float carried_grid_amount; flat out float grid_amount;
uniform float carried_grid_fade;   flat out float grid_fade;
uniform mat3 carried_shadow;       flat out mat3 shadow;
uniform float carried_shadow_fade; flat out float shadow_fade;
#endif

void main() {
#ifndef SKY
    eye = carried_eye;
    grid_color = carried_grid_color;
    ground = carried_ground;
    unit = carried_unit;
    grid_amount = carried_grid_amount;
    grid_fade = carried_grid_fade;
    shadow = carried_shadow;
    shadow_fade = carried_shadow_fade;
    vec4 far = world_from_clip * vec4(corner, ray_depth, 1.0);
    ray = far.xyz / far.w - eye;
#endif
    sky = mix(bottom_color, top_color, 0.5 * corner.y + 0.5);
    gl_Position = vec4(corner, 1.0, 1.0);
}
