// Which triangle each pixel of a photo sees.
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 clip_from_origin;

void main() { gl_Position = clip_from_origin * vec4(position, 1.0); }
