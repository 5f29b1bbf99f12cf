// What the ground is like: carried to the fragment shader, as a Look is.
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
