#version 330 core
// Spans a screen-aligned rectangle of the line width over the segment from..to.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 widthAndStyle;

uniform mat4 viewProjection;
uniform vec2 viewport;
uniform float scale;

noperspective out float along;   // pixels from the start of the line
noperspective out float across;  // pixels from its middle
flat out vec4 lineColor;
flat out float halfWidth;
flat out int style;

void main() {
    vec4 start = viewProjection * vec4(from, 1.0);
    vec4 end = viewProjection * vec4(to, 1.0);

    // Clip at the near plane before the division by w.
    float startSide = start.z + start.w, endSide = end.z + end.w;
    lineColor = color;
    halfWidth = 0.5 * widthAndStyle.x * scale;
    style = int(widthAndStyle.y + 0.5);
    along = across = 0.0;
    if (startSide <= 0.0 && endSide <= 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (startSide < 0.0) start = mix(start, end, startSide / (startSide - endSide));
    if (endSide < 0.0) end = mix(end, start, endSide / (endSide - startSide));

    vec2 startPixel = start.xy / start.w * 0.5 * viewport;
    vec2 endPixel = end.xy / end.w * 0.5 * viewport;
    vec2 direction = endPixel - startPixel;
    float pixels = length(direction);
    direction = pixels > 0.0 ? direction / pixels : vec2(1.0, 0.0);
    vec2 normal = vec2(-direction.y, direction.x);

    bool atEnd = (gl_VertexID & 2) != 0;
    float side = (gl_VertexID & 1) != 0 ? 1.0 : -1.0;
    float reach = halfWidth + 1.0;  // one pixel more for the soft edge
    vec4 here = atEnd ? end : start;
    vec2 offset = (normal * side + direction * (atEnd ? 0.5 : -0.5)) * reach;
    along = atEnd ? pixels : 0.0;
    across = side * reach;
    gl_Position = here + vec4(offset / (0.5 * viewport) * here.w, 0.0, 0.0);
}
