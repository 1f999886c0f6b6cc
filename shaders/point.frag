uniform vec4 color_in;
uniform float width; // px
uniform bool square;
uniform int part; // 0 the core, which hides what is behind; 1 its soft rim

noperspective in vec2 offset;

layout(location = 0) out vec4 color;

void main() {
    float d = square ? max(abs(offset.x), abs(offset.y)) : length(offset);
    float coverage = clamp(0.5 * width + 0.5 - d, 0.0, 1.0);
    if (coverage <= 0.0)
        discard;
    if ((coverage < 0.75) != (part == 1))
        discard;
    // A darker ring keeps points apart from a surface of their own colour.
    float ring = width >= 5.0 ? smoothstep(0.5 * width - 2.0, 0.5 * width - 1.0, d) : 0.0;
    color = vec4(color_in.rgb * (1.0 - 0.45 * ring), color_in.a * coverage);
}
