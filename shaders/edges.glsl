// Whether two texels of a traced picture, beside each other, show different things: one surface goes on where the normals
// are alike and the depths are near.
bool differ(vec4 here, vec4 there) {
    bool both = here.w > 0.0 && there.w > 0.0;
    float turned = both ? 1.0 - dot(here.xyz, there.xyz) : here.w > 0.0 != there.w > 0.0 ? 1.0 : 0.0;
    float stepped = both ? 40.0 * abs(here.w - there.w) / max(here.w, there.w) : 0.0;
    return max(5.0 * turned, stepped) > 0.5;
}
