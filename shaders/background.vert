#version 330 core
// One triangle that covers the picture; needs no vertex data.
out vec2 place;  // (0, 0) is the lower left corner of the picture

void main() {
    place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
