// The model as a photo's camera sees it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 clip_from_origin;
layout(location = 1) uniform mat3 cam_from_world;

out vec3 cam_normal;

void main() {
    cam_normal = cam_from_world * normal;
    gl_Position = clip_from_origin * vec4(position, 1.0);
}
