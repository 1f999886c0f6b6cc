// Paper: matt, lit by a lamp over the viewer's left shoulder and by a sky above and a floor below.
uniform vec4 front;
uniform vec4 back;
uniform vec4 highlight;
uniform bool lit;
uniform bool even; // a sky below, too
uniform bool ortho;
uniform vec3 up; // the world's z in view space

in vec3 view_position;
in vec3 view_normal;

const vec3 lamp = normalize(vec3(-0.45, 0.65, 0.85));
const float floor_light = 0.46, sky_light = 0.74, lamp_light = 0.36;
const float back_glow = 0.4; // backs stay lighter than fronts even turned away from the lamp

layout(location = 0) out vec4 color;

vec3 facing_normal() {
    vec3 n = view_normal;
    // No normals given: the triangle's own, from how its position changes over the screen.
    if (dot(n, n) < 0.25)
        n = cross(dFdx(view_position), dFdy(view_position));
    vec3 to_eye = ortho ? vec3(0.0, 0.0, 1.0) : -view_position;
    n = normalize(n);
    return dot(n, to_eye) < 0.0 ? -n : n;
}

void main() {
    vec3 c = gl_FrontFacing ? front.rgb : back.rgb;
    if (lit) {
        vec3 n = facing_normal();
        float height = even ? abs(dot(n, up)) : dot(n, up);
        float light = mix(floor_light, sky_light, 0.5 + 0.5 * height) +
                      lamp_light * max(dot(n, lamp), 0.0);
        c *= gl_FrontFacing ? light : mix(light, 1.0, back_glow);
    }
    color = vec4(mix(min(c, 1.0), highlight.rgb, highlight.a), front.a);
}
