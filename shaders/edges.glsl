// Whether a pixel of a traced picture holds more than one thing: whether what lies beside it is another surface.
bool is_edge(sampler2D centres, ivec2 at) {
    ivec2 last = textureSize(centres, 0) - 1;
    vec4 here = texelFetch(centres, at, 0);
    float difference = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 beside = at + ivec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
        vec4 there = texelFetch(centres, clamp(beside, ivec2(0), last), 0);
        bool both = here.w > 0.0 && there.w > 0.0;
        // One surface goes on where the normals are alike and the depths are near.
        float turned = both ? 1.0 - dot(here.xyz, there.xyz) : here.w > 0.0 != there.w > 0.0 ? 1.0 : 0.0;
        float stepped = both ? 40.0 * abs(here.w - there.w) / max(here.w, there.w) : 0.0;
        difference = max(difference, max(5.0 * turned, stepped));
    }
    return difference > 0.5;
}
