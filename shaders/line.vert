// One segment of a polyline as a rectangle facing the camera, with room for its round ends.
uniform mat4 model_view;
uniform mat4 projection;
uniform vec2 viewport;  // px
uniform float width;    // px
uniform vec2 mm_per_px; // .x + .y * depth
uniform float near;     // mm
uniform bool ortho;
uniform float raise;    // of the width, 0.75 where lines lie on surfaces

layout(location = 0) in vec4 start; // xyz, and the length of the polyline up to here
layout(location = 1) in vec4 end;
layout(location = 2) in vec3 normal_a; // see kg_segment
layout(location = 3) in vec3 normal_b;

noperspective out vec2 across;   // px, from `start`: along the segment, to its side
noperspective out float reach;   // px, length of the segment on the screen
out float arc_length;            // mm

// A line on a surface must win against it over its whole width, at any slope up to 45 degrees: draw it
// as if it were the nearest side of a rod of that width.
vec3 lift(vec3 p) {
    float by = raise * width * (mm_per_px.x - mm_per_px.y * p.z);
    return ortho ? p + vec3(0.0, 0.0, by) : p * (1.0 - min(by / length(p), 0.5));
}

void main() {
    vec4 a = vec4((model_view * vec4(start.xyz, 1.0)).xyz, start.w);
    vec4 b = vec4((model_view * vec4(end.xyz, 1.0)).xyz, end.w);

    vec3 to_eye = ortho ? vec3(0.0, 0.0, 1.0) : -a.xyz;
    mat3 turn = mat3(model_view);
    if (dot(turn * normal_a, to_eye) * dot(turn * normal_b, to_eye) > 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }

    float da = -a.z - near, db = -b.z - near; // cut at the near plane, where w may reach 0
    if (!ortho && da < 0.0 && db < 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (!ortho && da < 0.0)
        a = mix(a, b, da / (da - db));
    else if (!ortho && db < 0.0)
        b = mix(b, a, db / (db - da));

    vec4 ca = projection * vec4(lift(a.xyz), 1.0), cb = projection * vec4(lift(b.xyz), 1.0);
    vec2 pa = 0.5 * viewport * ca.xy / ca.w, pb = 0.5 * viewport * cb.xy / cb.w;
    reach = distance(pa, pb);
    vec2 along = reach > 1e-6 ? (pb - pa) / reach : vec2(1.0, 0.0);

    float margin = 0.5 * width + 1.0;
    bool at_end = (gl_VertexID & 1) != 0;
    float side = (gl_VertexID & 2) != 0 ? margin : -margin;
    across = vec2(at_end ? reach + margin : -margin, side);
    arc_length = at_end ? b.w : a.w;
    vec4 c = at_end ? cb : ca;
    vec2 p = pa + along * across.x + vec2(-along.y, along.x) * side;
    gl_Position = vec4(p * 2.0 / viewport * c.w, c.z, c.w);
}
