#version 330 core
noperspective in float along;
noperspective in float across;
flat in vec4 lineColor;
flat in float halfWidth;
flat in int style;

uniform float scale;
uniform sampler2D sceneDepth;
uniform bool depthKnown;
uniform float hiddenOpacity;

out vec4 fragment;

// Depth bias, so that lines on a surface are visible: depths have 24 bits.
const float kStepOfDepth = 1.0 / 8388608.0;

void main() {
    float coverage = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
    if (style == 1 && mod(along, 10.0 * scale) > 6.0 * scale) discard;
    if (style == 2 && mod(along, 5.0 * scale) > 2.0 * scale) discard;
    float opacity = lineColor.a * coverage;
    if (depthKnown && gl_FragCoord.z > texelFetch(sceneDepth, ivec2(gl_FragCoord.xy), 0).r + kStepOfDepth)
        opacity *= hiddenOpacity;
    fragment = vec4(lineColor.rgb, opacity);
}
