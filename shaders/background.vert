#version 330 core
// One triangle that covers the viewport; needs no vertex data.
out vec2 uv;  // (0, 0) is the lower left corner of the viewport

void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
