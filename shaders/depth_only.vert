// Depth of the model from a photo's camera; nothing else is written.
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 clip_from_origin;

void main() { gl_Position = clip_from_origin * vec4(position, 1.0); }
