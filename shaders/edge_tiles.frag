// Which tiles of a traced picture hold an edge: all that is done for each sample is done there only.
uniform sampler2D centres;  // what trace.frag wrote for the pixels' centres
uniform int tile_size;      // in pixels

out vec4 edge;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * tile_size, last = textureSize(centres, 0) - 1;
    float found = 0.0;
    for (int y = 0; y < tile_size; ++y)
        for (int x = 0; x < tile_size; ++x)
            if (is_edge(centres, min(first + ivec2(x, y), last))) found = 1.0;
    edge = vec4(found);
}
