// The mean of each pixel's samples. glBlitFramebuffer does the same, but Mesa compiles its own shader for that anew in
// every process, which cost a cold capture a quarter of its time. GLSL ES 3.00 has no multisample textures: a web build
// has to blit.
uniform sampler2DMS samples;
uniform int count;

out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(samples, at, 0) + texelFetch(samples, at, 1);
    if (count > 2) sum += texelFetch(samples, at, 2) + texelFetch(samples, at, 3);
    color = sum / float(count);
}
