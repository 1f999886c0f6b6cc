uniform vec4 top;
uniform vec4 bottom;

in float height; // 0 at the lower edge, 1 at the upper

layout(location = 0) out vec4 color;

void main() {
    vec4 c = mix(bottom, top, height);
    color = vec4(c.rgb * c.a, c.a);
}
