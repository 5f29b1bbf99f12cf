// The ground behind everything: a quiet gradient, a grid that fades out, and a soft shadow under the object; and over it
// what has been drawn, the mean of each pixel's samples. This covers every pixel, so each operation here counts on a
// processor, but the ground is worked out once for all samples. glBlitFramebuffer would take the mean as well, but Mesa
// compiles its own shader for that anew in every process. GLSL ES 3.00 has no multisample textures: there each sample is a
// texel of its own, or they have been averaged before.
in vec3 sky;
#ifndef SKY
in vec3 ray;
flat in vec3 eye;
flat in vec3 grid_color;
flat in float ground;       // height of the grid
flat in float unit;         // between the grid's lines
flat in float grid_amount;  // 0: no grid
flat in float grid_fade;    // with the square of the distance
flat in mat3 shadow;        // from (x, z, 1) on the ground to the unit disc
flat in float shadow_fade;
#endif

#ifdef RESOLVE
#ifdef APART
uniform sampler2D drawn;    // colours times alpha
uniform ivec2 drawn_step;   // from one sample's pixels to the next one's, in a square of four
#else
uniform sampler2DMS drawn;
#endif
uniform int samples;
uniform ivec2 drawn_low;    // the pixel that the samples begin with,
uniform ivec2 drawn_size;   // and how many they go on for
#endif

out vec4 color;

const float HALF_WIDTH = 0.009;

#ifdef SKY
vec3 backdrop() { return sky; }  // where nothing of the ground is seen: the same, in far fewer steps
#else
vec3 backdrop() {
    float t = (ground - eye.y) / ray.y;
    vec2 at = eye.xz + t * ray.xz;
    // How much of the pixel a line at each whole number covers; a line thinner than a pixel grows fainter instead.
    vec2 place = at / unit, pixel = fwidth(place) + 1e-5;
    vec2 away = 0.5 - abs(fract(place) - 0.5);
    vec2 covered = clamp((HALF_WIDTH - away) / pixel + 0.5, 0.0, 1.0) * min(2.0 * HALF_WIDTH / pixel, 1.0);
    float fade = max(1.0 - grid_fade * dot(place, place), 0.0);
    vec2 in_shadow = (shadow * vec3(at, 1.0)).xy;
    float dark = max(1.0 - shadow_fade * dot(in_shadow, in_shadow), 0.0);
    float amount = t > 0.0 ? grid_amount : 0.0;
    vec3 c = sky * (1.0 - 0.24 * amount * dark * dark * dark);
    return mix(c, grid_color, 0.7 * amount * fade * fade * max(covered.x, covered.y));
}
#endif

void main() {
    color = vec4(backdrop(), 1.0);
#ifdef RESOLVE
    ivec2 at = ivec2(gl_FragCoord.xy) - drawn_low;
#ifdef SAMPLES  // and each pixel has them
    const int count = SAMPLES;
#else
    bool inside = min(at.x, at.y) >= 0 && at.x < drawn_size.x && at.y < drawn_size.y;
    int count = inside ? samples : 0;
#endif
    vec4 sum = vec4(0.0);
#ifdef APART
    for (int i = 0; i < count; ++i) sum += texelFetch(drawn, at + ivec2(i & 1, i >> 1) * drawn_step, 0);
#else
    for (int i = 0; i < count; ++i) sum += texelFetch(drawn, at, i);
#endif
    sum /= float(max(count, 1));
    color.rgb = sum.rgb + (1.0 - sum.a) * color.rgb;
#endif
}
