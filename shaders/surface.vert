// Triangles of a surface, in view space.
uniform mat4 model_view;
uniform mat4 projection;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 view_position;
out vec3 view_normal;

void main() {
    vec4 p = model_view * vec4(position, 1.0);
    view_position = p.xyz;
    view_normal = mat3(model_view) * normal;
    gl_Position = projection * p;
}
