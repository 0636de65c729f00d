#include "player/view/panorama.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/text/error.h"

namespace vantage {

using Eigen::Vector3d;

Panorama panorama_at(const View& view, const Vector3d& up, FrameSize size) {
    if (size.height < 1 || size.width != 2 * size.height)
        throw Error(Exit::usage, "--panorama: a picture of " + std::to_string(size.width) + "x" +
                                     std::to_string(size.height) +
                                     ", expected a picture twice as wide as high");
    const Vector3d down = -up.normalized();
    const Pose& pose = view.cam_from_origin;
    Vector3d right = down.cross(pose.direction());
    // For a vertical view, the picture's upper or lower edge defines the forward direction.
    if (right.norm() < 1e-6) right = pose.R.row(0).transpose() - pose.R.row(0).dot(down) * down;
    right.normalize();
    Panorama out{pose.center(), {}, size};
    out.R << right.transpose(), down.transpose(), right.cross(down).transpose();
    return out;
}

Eigen::Vector2d pixel_of(const Panorama& p, const Vector3d& d) {
    const double longitude = std::atan2(d.x(), d.z()), below = std::atan2(d.y(), std::hypot(d.x(), d.z()));
    return {(longitude / (2 * std::numbers::pi) + 0.5) * p.size.width,
            (below / std::numbers::pi + 0.5) * p.size.height};
}

std::array<Eigen::Matrix3d, 6> cube_axes() {
    const auto turned = [](double degrees, const Vector3d& about) {
        return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, about).toRotationMatrix();
    };
    const Vector3d y = Vector3d::UnitY(), x = Vector3d::UnitX();
    return {turned(0, y), turned(-90, y), turned(180, y), turned(90, y), turned(-90, x), turned(90, x)};
}

std::array<View, 6> cube_views(const Panorama& panorama, double finer, double margin) {
    const int inside = std::max(2, int(std::lround(finer * panorama.size.width / std::numbers::pi)));
    const int side = inside + 2 * std::max(2, int(std::ceil(margin * inside)));
    std::array<View, 6> out;
    const auto axes = cube_axes();
    for (std::size_t face = 0; face < 6; ++face) {
        out[face].intrinsics = {side, side, inside / 2.0, inside / 2.0, side / 2.0, side / 2.0};
        out[face].cam_from_origin.R = axes[face] * panorama.R;
        out[face].cam_from_origin.t = -out[face].cam_from_origin.R * panorama.eye;
    }
    return out;
}

std::string panorama_xmp(FrameSize size) {
    const std::string width = std::to_string(size.width), height = std::to_string(size.height);
    const auto field = [](const std::string& name, const std::string& value) {
        return "\n   GPano:" + name + "=\"" + value + "\"";
    };
    return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
           "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
           " <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
           "  <rdf:Description rdf:about=\"\" xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\"" +
           field("ProjectionType", "equirectangular") + field("UsePanoramaViewer", "True") +
           field("FullPanoWidthPixels", width) + field("FullPanoHeightPixels", height) +
           field("CroppedAreaImageWidthPixels", width) + field("CroppedAreaImageHeightPixels", height) +
           field("CroppedAreaLeftPixels", "0") + field("CroppedAreaTopPixels", "0") +
           field("PosePitchDegrees", "0") + field("PoseRollDegrees", "0") +
           "/>\n </rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>";
}

}  // namespace vantage
