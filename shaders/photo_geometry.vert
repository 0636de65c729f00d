// Draws the model as a photo's camera sees it.
#include "contract.glsl"

layout(location = position_attribute) in vec3 position;
layout(location = normal_attribute) in vec3 normal;
layout(location = clip_from_model_uniform) uniform mat4 clip_from_origin;
layout(location = cam_from_world_uniform) uniform mat3 cam_from_world;

out vec3 cam_normal;

void main() {
    cam_normal = cam_from_world * normal;
    gl_Position = clip_from_origin * vec4(position, 1.0);
}
