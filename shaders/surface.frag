#version 330 core
// A headlight plus the lights of the scene, without shadows.
in vec3 worldPosition;
in vec3 worldNormal;
in vec2 uv;

uniform vec3 eye;
uniform vec3 kd, ks;
uniform float shininess;
uniform float opacity;
uniform bool useNormals, useTexture;
uniform sampler2D kdTexture;
uniform int lightCount;
uniform vec3 lightPositions[8];
uniform vec3 lightColors[8];

out vec4 fragment;

const float kAmbient = 0.16, kHeadlight = 0.34, kSceneLights = 0.6;

// Approximates the sRGB curve within 0.002 from 0.003 to 1 with square roots.
vec3 srgb(vec3 linear) {
    vec3 root2 = sqrt(linear), root4 = sqrt(root2), root8 = sqrt(root4);
    return 0.585122381 * root2 + 0.783140355 * root4 - 0.368262736 * root8;
}

void main() {
    vec3 toEye = normalize(eye - worldPosition);
    vec3 flatNormal = normalize(cross(dFdx(worldPosition), dFdy(worldPosition)));
    vec3 normal = useNormals ? normalize(worldNormal) : flatNormal;
    if (dot(normal, toEye) < 0.0) normal = -normal;
    // The texture's first row is the top of the picture.
    vec3 diffuse = useTexture ? texture(kdTexture, vec2(uv.x, 1.0 - uv.y)).rgb : kd;
    // A perfect mirror would be black here.
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
