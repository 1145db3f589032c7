#version 330 core
noperspective in float along;
noperspective in float across;
flat in vec4 lineColor;
flat in float halfWidth;
flat in int style;

uniform float opacity;
uniform float scale;

out vec4 fragment;

void main() {
    float coverage = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
    if (style == 1 && mod(along, 10.0 * scale) > 6.0 * scale) discard;
    if (style == 2 && mod(along, 5.0 * scale) > 2.0 * scale) discard;
    fragment = vec4(lineColor.rgb, lineColor.a * opacity * coverage);
}
