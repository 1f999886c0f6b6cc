// One point as a square facing the camera.
uniform mat4 model_view;
uniform mat4 projection;
uniform vec2 viewport;  // px
uniform float width;    // px
uniform vec2 mm_per_px; // .x + .y * depth
uniform bool ortho;

layout(location = 0) in vec3 position;

noperspective out vec2 offset; // px

void main() {
    vec3 p = (model_view * vec4(position, 1.0)).xyz;
    // Lifted a little more than lines, so that points sit on them.
    float by = width * (mm_per_px.x - mm_per_px.y * p.z);
    p = ortho ? p + vec3(0.0, 0.0, by) : p * (1.0 - min(by / length(p), 0.5));
    vec4 c = projection * vec4(p, 1.0);
    float margin = 0.5 * width + 1.0;
    offset = vec2((gl_VertexID & 1) != 0 ? margin : -margin,
                  (gl_VertexID & 2) != 0 ? margin : -margin);
    gl_Position = vec4(c.xy + offset * 2.0 / viewport * c.w, c.z, c.w);
}
