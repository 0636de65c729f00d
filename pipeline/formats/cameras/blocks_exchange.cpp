#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <string_view>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/skipped_cameras.h"
#include "pipeline/formats/xml_file.h"

namespace vantage {
namespace {

/// The axes of a CameraOrientation, as rows: the photo's right and down directions.
struct Orientation {
    const char* name;
    Eigen::Vector3d right, down;
};
const Orientation orientations[] = {
    {"XRightYDown", {1, 0, 0}, {0, 1, 0}}, {"XRightYUp", {1, 0, 0}, {0, -1, 0}},
    {"XLeftYDown", {-1, 0, 0}, {0, 1, 0}}, {"XLeftYUp", {-1, 0, 0}, {0, -1, 0}},
    {"XDownYRight", {0, 1, 0}, {1, 0, 0}}, {"XDownYLeft", {0, -1, 0}, {1, 0, 0}},
    {"XUpYRight", {0, 1, 0}, {-1, 0, 0}},  {"XUpYLeft", {0, -1, 0}, {-1, 0, 0}}};

/// The rotation from the camera's axes to ours. The camera's x and y lie in the photo, and z completes a
/// right-handed system.
Eigen::Matrix3d axes_of(const XmlFile& file, pugi::xml_node group) {
    const pugi::xml_node orientation = group.child("CameraOrientation");
    if (!orientation) return Eigen::Matrix3d::Identity();
    for (const Orientation& o : orientations) {
        if (std::string_view(orientation.child_value()) != o.name) continue;
        Eigen::Matrix3d out;
        out << o.right.transpose(), o.down.transpose(), o.right.cross(o.down).transpose();
        return out;
    }
    file.fail(orientation, "XRightYDown or one of the seven other orientations",
              std::string("'") + orientation.child_value() + "'");
}

double focal_of(const XmlFile& file, pugi::xml_node group, double side) {
    if (group.child("FocalLengthPixels")) return file.number(group, "FocalLengthPixels");
    const double mm = file.number(group, "FocalLength");
    if (group.child("SensorSize")) return mm * side / file.number(group, "SensorSize");
    return mm / file.number(group, "PixelSize");
}

/// The principal point, given in pixels from the center of the first pixel, or in mm from the center of the
/// sensor.
Eigen::Vector2d center_of(const XmlFile& file, pugi::xml_node group, const Intrinsics& k, double side) {
    const Eigen::Vector2d middle(k.width / 2.0, k.height / 2.0);
    if (const pugi::xml_node p = group.child("PrincipalPoint"))
        return Eigen::Vector2d(file.number(p, "x"), file.number(p, "y")).array() + 0.5;
    const pugi::xml_node p = group.child("PrincipalPointMM");
    if (!p) return middle;
    const double pixels = group.child("SensorSize") ? side / file.number(group, "SensorSize")
                                                    : 1 / file.number(group, "PixelSize");
    return middle + pixels * Eigen::Vector2d(file.number(p, "x"), file.number(p, "y"));
}

/// The camera of a group of photos. P1 and P2 are OpenCV's p2 and p1.
Camera read_group(const XmlFile& file, pugi::xml_node group) {
    const std::string_view model = group.child_value("CameraModelType");
    if (!model.empty() && model != "Perspective")
        file.fail(group.child("CameraModelType"), "Perspective", "'" + std::string(model) + "'");
    Camera c;
    Intrinsics& k = c.intrinsics;
    const pugi::xml_node size = group.child("ImageDimensions");
    k.width = file.size(size ? size : group, file.number(size ? size : group, "Width"));
    k.height = file.size(size, file.number(size, "Height"));
    const double side = std::max(k.width, k.height);
    k.fx = focal_of(file, group, side);
    k.fy = k.fx * file.number(group, "AspectRatio", 1);
    if (!(k.fx > 0)) file.fail(group, "a focal length above 0", std::to_string(k.fx));
    const Eigen::Vector2d center = center_of(file, group, k, side);
    k.cx = center.x();
    k.cy = center.y();
    const pugi::xml_node d = group.child("Distortion");
    const auto value = [&](const char* name) { return file.number(d, name, 0); };
    c.lens = brown_lens({value("K1"), value("K2"), value("K3"), 0}, value("P2"), value("P1"),
                        file.number(group, "Skew", 0) / k.fx);
    return c;
}

/// The rotation from the world to the camera's axes. The metadata next to the rotation describes the pose of
/// the navigation device, not of the camera.
Eigen::Matrix3d blocks_rotation(const XmlFile& file, pugi::xml_node rotation) {
    Eigen::Matrix3d R;
    if (!rotation.child("M_00"))
        file.fail(rotation, "a matrix, M_00 to M_22", "angles: export the matrix instead");
    for (int i = 0; i < 9; ++i) {
        const std::string name = "M_" + std::to_string(i / 3) + std::to_string(i % 3);
        R(i / 3, i % 3) = file.number(rotation, name.c_str());
    }
    return R;
}

/// The block's coordinate system if it is geographic; empty if it is local or not given.
std::string geographic_system(pugi::xml_node root) {
    const std::string id = root.child("Block").child_value("SRSId");
    for (const pugi::xml_node s : root.child("SpatialReferenceSystems").children("SRS"))
        if (std::string_view(s.child_value("Id")) == id &&
            s.child_value("Definition") == std::string("EPSG:4326"))
            return s.child_value("Name");
    return {};
}

void read_photos(const XmlFile& file, pugi::xml_node group, CameraSet& set, SkippedCameras& skipped) {
    const Camera camera = read_group(file, group);
    const Eigen::Matrix3d axes = axes_of(file, group);
    for (const pugi::xml_node photo : group.children("Photo")) {
        const std::string name = photo.child_value("ImagePath");
        const pugi::xml_node pose = photo.child("Pose"), rotation = pose.child("Rotation"),
                             center = pose.child("Center");
        if (!rotation || !center) {
            skipped.add(name, "no pose");
            continue;
        }
        const Eigen::Matrix3d R = axes * blocks_rotation(file, rotation);
        const Eigen::Vector3d c(file.number(center, "x"), file.number(center, "y"), file.number(center, "z"));
        set.entries.push_back({name, camera, CameraSet::Unit::pixels});
        set.entries.back().camera.cam_from_world = {R, -R * c};
    }
}

}  // namespace

CameraSet read_blocks_exchange(const std::filesystem::path& path) {
    const XmlFile file(path);
    const pugi::xml_node root = file.child("BlocksExchange"),
                         groups = root.child("Block").child("Photogroups");
    if (!groups) throw NoCamera(path.string() + ": expected BlocksExchange with Photogroups, found none");
    CameraSet set{"Blocks Exchange", {}, {}};
    SkippedCameras skipped;
    for (const pugi::xml_node group : groups.children("Photogroup")) read_photos(file, group, set, skipped);
    skipped.tell(set.warnings);
    if (const std::string system = geographic_system(root); !system.empty())
        set.warnings.push_back("positions are longitudes and latitudes (" + system +
                               "): expected a local or projected coordinate system");
    if (set.entries.empty()) skipped.fail(path);
    return set;
}

}  // namespace vantage
