#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/json_file.h"
#include "pipeline/formats/skipped_cameras.h"

namespace vantage {
namespace {

using Version = std::tuple<int, int, int>;

Version version_of(const LocatedJson& root) {
    const std::vector<double> v = numerals(root.at("version"), 3);
    return {int(v[0]), int(v[1]), int(v[2])};
}

/// fx and fy in pixels. Since version 1.2.2, the file contains a focal length in millimeters and a pixel
/// ratio, which was fx / fy before version 1.2.5.
std::array<double, 2> focal_of(const LocatedJson& i, const Version& version) {
    if (version < Version(1, 2, 0)) {
        const double f = numeral(i.at("pxFocalLength"));
        return {f, f};
    }
    if (version < Version(1, 2, 2)) {
        const std::vector<double> f = numerals(i.at("pxFocalLength"), 2);
        return {f[0], f[1]};
    }
    const double sensor = numeral(i.at("sensorWidth")), ratio = numeral(i, "pixelRatio", 1);
    if (!(sensor > 0)) i.at("sensorWidth").fail("a width above 0");
    if (!(ratio > 0)) i.at("pixelRatio").fail("a ratio above 0");
    const double f = numeral(i.at("focalLength")) * numeral(i.at("width")) / sensor;
    if (version >= Version(1, 2, 11)) return {f / ratio, f};
    return {f, version < Version(1, 2, 5) ? f / ratio : f * ratio};
}

std::vector<double> coefficients_of(const LocatedJson& i) {
    if (!i.has("distortionParams") || i.at("distortionParams").is_text()) return {};  // "" for none
    const LocatedJson list = i.at("distortionParams");
    return numerals(list, list.items(max_cameras).size());
}

/// The lens of `distortionType`, or of `type` up to version 1.2.7.
Lens lens_of(const LocatedJson& i) {
    if (i.has("undistortionType") && i.at("undistortionType").text(100) != "none")
        i.at("undistortionType").fail("none: such a lens is not supported");
    const LocatedJson type = i.at(i.has("distortionType") ? "distortionType" : "type");
    const std::string name = type.text(100);
    const std::vector<double> c = coefficients_of(i);
    const auto has = [&](std::size_t count) {
        if (c.size() != count) i.at("distortionParams").fail(std::to_string(count) + " numbers for " + name);
        return true;
    };
    if (name == "none" || name == "pinhole") return {};
    if (name == "radialk1" || name == "radial1") return has(1), brown_lens({c[0], 0, 0, 0}, 0, 0, 0);
    if (name == "radialk3" || name == "radial3") return has(3), brown_lens({c[0], c[1], c[2], 0}, 0, 0, 0);
    if (name == "brown") return has(5), brown_lens({c[0], c[1], c[2], 0}, c[3], c[4], 0);
    if (name == "fisheye4") return has(4), Lens{LensModel::fisheye, {c[0], c[1], c[2], c[3]}};
    type.fail("none, radialk1, radialk3, brown or fisheye4");
}

Camera read_intrinsic(const LocatedJson& i, const Version& version) {
    Camera c;
    Intrinsics& k = c.intrinsics;
    k.width = photo_size(i.at("width"));
    k.height = photo_size(i.at("height"));
    const std::array<double, 2> f = focal_of(i, version);
    const std::vector<double> center = numerals(i.at("principalPoint"), 2);
    const bool from_corner = version < Version(1, 2, 1);
    k.fx = f[0];
    k.fy = f[1];
    k.cx = center[0] + (from_corner ? 0 : k.width / 2.0);
    k.cy = center[1] + (from_corner ? 0 : k.height / 2.0);
    c.lens = lens_of(i);
    return c;
}

/// The rotation from world to camera is stored by columns.
Pose meshroom_pose(const LocatedJson& pose) {
    const LocatedJson transform = pose.at("pose").at("transform");
    const std::vector<double> r = numerals(transform.at("rotation"), 9),
                              c = numerals(transform.at("center"), 3);
    Eigen::Matrix3d R;
    for (std::size_t i = 0; i < 9; ++i) R(Eigen::Index(i % 3), Eigen::Index(i / 3)) = r[i];
    return {R, -R * Eigen::Vector3d(c[0], c[1], c[2])};
}

bool is_in_rig(const LocatedJson& view) { return view.has("rigId") && view.has("subPoseId"); }

}  // namespace

CameraSet read_meshroom(const std::filesystem::path& file) {
    JsonFile json(file);
    const LocatedJson root = json.root();
    const Version version = version_of(root);
    std::map<std::string, LocatedJson> intrinsics;
    for (const LocatedJson& i : root.at("intrinsics").items(max_cameras))
        intrinsics.emplace(identifier(i.at("intrinsicId")), i);
    std::map<std::string, Pose> poses;
    if (root.has("poses"))
        for (const LocatedJson& p : root.at("poses").items(max_cameras))
            poses[identifier(p.at("poseId"))] = meshroom_pose(p);
    CameraSet set{"Meshroom", {}, {}};
    SkippedCameras skipped;
    for (const LocatedJson& view : root.at("views").items(max_cameras)) {
        const std::string photo = view.at("path").text(10000);
        const auto pose = poses.find(identifier(view.at("poseId")));
        const auto intrinsic = intrinsics.find(identifier(view.at("intrinsicId")));
        if (pose == poses.end() || is_in_rig(view)) {
            skipped.add(photo, is_in_rig(view) ? "part of a rig" : "no pose");
            continue;
        }
        if (intrinsic == intrinsics.end()) view.at("intrinsicId").fail("the ID of an intrinsic in this file");
        set.entries.push_back({photo, read_intrinsic(intrinsic->second, version), CameraSet::Unit::pixels});
        set.entries.back().camera.cam_from_world = pose->second;
    }
    skipped.tell(set.warnings);
    if (set.entries.empty()) skipped.fail(file);
    return set;
}

}  // namespace vantage
