// Linear depth and viewing angle of the model from a photo's camera.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 clip_from_origin;
layout(location = 1) uniform mat4 cam_from_origin;

out vec3 cam_position;
out vec3 cam_normal;

void main() {
    cam_position = (cam_from_origin * vec4(position, 1.0)).xyz;
    cam_normal = mat3(cam_from_origin) * normal;
    gl_Position = clip_from_origin * vec4(position, 1.0);
}
