in vec3 cam_position;
in vec3 cam_normal;
layout(location = 0) out float linear_z;
layout(location = 1) out float angle;  // Callieri et al. 2008: cosine between normal and direction to the camera
layout(location = 2) out uint triangle;

void main() {
    linear_z = cam_position.z;
    float lengths = length(cam_normal) * length(cam_position);
    angle = lengths > 0.0 ? max(0.0, -dot(cam_normal, cam_position) / lengths) : 0.0;
    triangle = uint(gl_PrimitiveID);
}
