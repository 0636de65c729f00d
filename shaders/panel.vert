// Places a vertex of a user interface on a plane.
#include "contract.glsl"

layout(location = position_attribute) in vec2 position;  // panel pixels
layout(location = texture_attribute) in vec2 texture_place;
layout(location = color_attribute) in vec4 color;
layout(location = clip_from_origin_uniform) uniform mat4 clip_from_panel;
out vec2 place;
out vec2 at;
out vec4 tint;

void main() {
    place = position;
    at = texture_place;
    tint = color;
    gl_Position = clip_from_panel * vec4(position, 0.0, 1.0);
}
