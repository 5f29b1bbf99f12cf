// One triangle over the whole pane. What the fragments need of it is linear in their place, so nothing is handed on.
layout(location = 0) in vec2 corner;  // in clip space

void main() { gl_Position = vec4(corner, 1.0, 1.0); }
