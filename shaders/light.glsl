// Colours are sRGB. Squares and square roots stand in for its curve: near enough to the eye, and flat colours come out
// exactly as they went in.
vec3 to_light(vec3 c) { return c * c; }
vec3 to_srgb(vec3 c) { return sqrt(clamp(c, 0.0, 1.0)); }

// What leaves a place of that normal toward the eye, of a colour that is its meaning, or of a surface.
vec3 lit(vec3 base, vec3 n, vec3 toward_eye, vec3 toward_light, bool color_coded) {
    float diffuse = dot(n, toward_light);
    // Light wraps a little around the edge, and the sky is brighter than the ground.
    float amount = 0.26 + 0.12 * n.y + 0.72 * max(0.85 * diffuse + 0.15, 0.0);
    if (color_coded) amount = 0.55 + 0.5 * amount;  // light gives it shape but must not drown it
    vec3 halfway = normalize(toward_light + toward_eye);
    float shine = max(dot(n, halfway), 0.0);
    shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
    return to_light(base) * amount + vec3(0.10) * shine * step(0.0, diffuse);
}
