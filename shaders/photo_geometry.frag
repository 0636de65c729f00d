// Writes the linear depth, the viewing angle and the triangle at each pixel of a photo.
#include "contract.glsl"

in vec3 cam_normal;
layout(location = focal_center_uniform) uniform vec4 focal_center;  // fx fy cx cy, pixels
layout(location = linear_z_output) out float linear_z;
// The cosine of the angle between the normal and the direction to the camera (Callieri et al. 2008).
layout(location = angle_output) out float angle;
layout(location = triangle_output) out uint triangle;

void main() {
    linear_z = 1.0 / gl_FragCoord.w;  // the clip matrix puts z into w
    vec3 ray = vec3((gl_FragCoord.xy - focal_center.zw) / focal_center.xy, 1.0);
    float lengths = length(cam_normal) * length(ray);
    angle = lengths > 0.0 ? max(0.0, -dot(cam_normal, ray) / lengths) : 0.0;
    triangle = uint(gl_PrimitiveID);
}
