// The ground behind everything: a quiet gradient, a grid that fades out, and a soft shadow under the object. It covers
// every pixel, so each operation here counts on a processor.
in vec3 ray;
in vec3 sky;

uniform vec3 grid_color;
uniform vec3 eye;
uniform float ground;       // height of the grid
uniform float grid_amount;  // 0: no grid
uniform mat3 shadow;        // from (x, z, 1) on the ground to the unit disc

out vec4 color;

const float HALF_WIDTH = 0.009;

void main() {
    float t = (ground - eye.y) / ray.y;
    vec2 at = eye.xz + t * ray.xz;
    // How much of the pixel a line at each whole number covers; a line thinner than a pixel grows fainter instead.
    vec2 pixel = fwidth(at) + 1e-5;
    vec2 away = 0.5 - abs(fract(at) - 0.5);
    vec2 covered = clamp((HALF_WIDTH - away) / pixel + 0.5, 0.0, 1.0) * min(2.0 * HALF_WIDTH / pixel, 1.0);
    float fade = max(1.0 - 0.021 * dot(at, at), 0.0);
    vec2 in_shadow = (shadow * vec3(at, 1.0)).xy;
    float dark = max(1.0 - 0.3 * dot(in_shadow, in_shadow), 0.0);
    float amount = t > 0.0 ? grid_amount : 0.0;
    vec3 c = sky * (1.0 - 0.24 * amount * dark * dark * dark);
    color = vec4(mix(c, grid_color, 0.7 * amount * fade * fade * max(covered.x, covered.y)), 1.0);
}
