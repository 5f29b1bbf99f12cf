// Nothing is written: what counts is whether a sample would be.
out vec4 color;

void main() { color = vec4(1.0); }
