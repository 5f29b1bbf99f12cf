// What the ground is like. It comes to the fragment shader as what a triangle carries: Mesa's software driver fetches each number
// of a uniform for every pixel anew. (Where triangles are small and many, that would cost more than it saves.)
struct Ground {
    vec3 eye;
    float height;       // of the grid
    vec3 grid_color;
    float unit;         // between the grid's lines
    mat3 shadow;        // from (x, z, 1) on the ground to the unit disc
    float shadow_fade;
    float grid_fade;    // with the square of the distance
    float grid_amount;  // 0: no grid
};
