#version 330 core
// Display transform of linear radiance: exposure, then the encoding.
in vec2 place;

uniform sampler2D image;
uniform sampler2D other;
uniform bool difference;    // show the absolute difference of `image` and `other`
uniform bool onePixelEach;  // image and screen have the same size
uniform float exposureFactor;
uniform bool courseCurve;

out vec4 fragment;

vec3 srgb(vec3 linear) {
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(max(linear, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
    ivec2 size = textureSize(image, 0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 radiance = onePixelEach ? texelFetch(image, ivec2(pixel.x, size.y - 1 - pixel.y), 0).rgb
                                 : texture(image, vec2(place.x, 1.0 - place.y)).rgb;
    if (difference) radiance = abs(radiance - texture(other, vec2(place.x, 1.0 - place.y)).rgb);
    radiance *= exposureFactor;
    // Non-finite values are magenta.
    if (any(isnan(radiance)) || any(isinf(radiance))) radiance = vec3(1.0, 0.0, 1.0);
    radiance = clamp(radiance, 0.0, 1.0);
    fragment = vec4(courseCurve ? radiance : srgb(radiance), 1.0);
}
