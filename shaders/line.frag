uniform vec4 color_in;
uniform float width;       // px
uniform vec4 dashes;       // px: on, off, on, off
uniform float px_per_mm;   // at the camera's center, so that dashes keep still
uniform int part;          // 0 the core, which hides what is behind; 1 its soft rim

noperspective in vec2 across;
noperspective in float reach;
in float arc_length;

layout(location = 0) out vec4 color;

bool in_gap() {
    float period = dashes.x + dashes.y + dashes.z + dashes.w;
    if (period <= 0.0)
        return false;
    float s = mod(arc_length * px_per_mm, period);
    return s > dashes.x && (s < dashes.x + dashes.y || s > period - dashes.w);
}

void main() {
    float d = length(vec2(across.x - clamp(across.x, 0.0, reach), across.y));
    float coverage = clamp(0.5 * width + 0.5 - d, 0.0, 1.0);
    if (coverage <= 0.0 || in_gap())
        discard;
    if ((coverage < 0.75) != (part == 1))
        discard;
    color = vec4(color_in.rgb, color_in.a * coverage * min(width, 1.0));
}
