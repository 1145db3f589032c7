#version 330 core
in vec2 place;
out vec4 fragment;

const vec3 kBottom = vec3(0.105, 0.115, 0.130), kTop = vec3(0.205, 0.220, 0.245);

void main() {
    // Dither by half a step against banding at 8 bits.
    float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
    fragment = vec4(mix(kBottom, kTop, place.y) + noise / 255.0, 1.0);
}
