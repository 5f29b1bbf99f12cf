// What is the same for all of a draw, in the fragment shader. It comes there as what a triangle carries: Mesa's software driver
// fetches each number of a uniform for every pixel anew.
struct Look {
    vec3 toward_light;
    vec3 eye;
    float outside;         // +1 or -1: the winding that the normals take for outside; 0: no side is the inside
    float color_coded;     // 1: an arrow or mark, whose colour is its meaning
    vec3 inside_color;
    float unit_at_pixels;  // 1: make interpolated normals of unit length again, as one should
    float zero_is_black;   // 1: show a normal of length zero as the NaN that it would become
    float ghost;           // 1: a glassy shell, clearest where one looks straight through
};
