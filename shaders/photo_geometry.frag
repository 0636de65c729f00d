// Linear depth, viewing angle and triangle of what a photo's camera sees.
in vec3 cam_normal;
layout(location = 2) uniform vec4 focal_center;  // fx fy cx cy, pixels
layout(location = 0) out float linear_z;
layout(location = 1) out float angle;  // Callieri et al. 2008: cosine between normal and direction to the camera
layout(location = 2) out uint triangle;

void main() {
    linear_z = 1.0 / gl_FragCoord.w;  // the clip matrix keeps z in w
    vec3 ray = vec3((gl_FragCoord.xy - focal_center.zw) / focal_center.xy, 1.0);
    float lengths = length(cam_normal) * length(ray);
    angle = lengths > 0.0 ? max(0.0, -dot(cam_normal, ray) / lengths) : 0.0;
    triangle = uint(gl_PrimitiveID);
}
