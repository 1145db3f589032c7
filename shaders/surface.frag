#version 330 core
// Raster preview: a headlight plus the lights of the scene, without shadows.
in vec3 worldPosition;
in vec3 worldNormal;
in vec2 uv;
in vec3 vertexColor;

uniform vec3 eye;
uniform vec3 kd, ks;
uniform float shininess;
uniform float opacity;
uniform bool useNormals, useTexture, useColors;
uniform sampler2D kdTexture;
uniform int lightCount;
uniform vec3 lightPositions[8];
uniform vec3 lightColors[8];

out vec4 fragment;

const float kAmbient = 0.16, kHeadlight = 0.34, kSceneLights = 0.6;

// The sRGB curve within 0.002 from 0.003 to 1; square roots are cheaper than pow, and the preview needs no more.
vec3 srgb(vec3 linear) {
    vec3 root2 = sqrt(linear), root4 = sqrt(root2), root8 = sqrt(root4);
    return 0.585122381 * root2 + 0.783140355 * root4 - 0.368262736 * root8;
}

void main() {
    vec3 toEye = normalize(eye - worldPosition);
    vec3 flatNormal = normalize(cross(dFdx(worldPosition), dFdy(worldPosition)));
    vec3 normal = useNormals ? normalize(worldNormal) : flatNormal;
    if (dot(normal, toEye) < 0.0) normal = -normal;
    // The first row of the texture is the top of the image.
    vec3 texel = useTexture ? texture(kdTexture, vec2(uv.x, 1.0 - uv.y)).rgb : vec3(1.0);
    vec3 diffuse = useColors ? texel * vertexColor : useTexture ? texel : kd;
    // A mirror has kd near 0 and would be black.
    diffuse = max(diffuse, 0.5 * ks + 0.02);

    vec3 light = vec3(kAmbient + kHeadlight * dot(normal, toEye));
    vec3 highlight = vec3(0.0);
    for (int i = 0; i < lightCount; ++i) {
        vec3 toLight = normalize(lightPositions[i] - worldPosition);
        float cosine = max(dot(normal, toLight), 0.0);
        light += kSceneLights * cosine * lightColors[i];
        if (cosine > 0.0)
            highlight += pow(max(dot(reflect(-toLight, normal), toEye), 0.0), shininess) * lightColors[i];
    }
    vec3 color = diffuse * light + 0.4 * ks * highlight;
    fragment = vec4(srgb(min(color, vec3(1.0))), opacity);
}
