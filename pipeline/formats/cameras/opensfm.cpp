#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/json_file.h"

namespace vantage {
namespace {

Lens opensfm_lens(const LocatedJson& c) {
    const auto value = [&](const char* key) { return numeral(c, key, 0); };
    const std::string type = c.at("projection_type").text(100);
    if (type == "perspective" || type == "brown" || type == "radial" || type == "simple_radial")
        return brown_lens({value("k1"), value("k2"), value("k3"), 0}, value("p1"), value("p2"), 0);
    if (type == "fisheye" || type == "fisheye_opencv")
        return {LensModel::fisheye, {value("k1"), value("k2"), value("k3"), value("k4")}};
    c.at("projection_type").fail("perspective, brown, radial, simple_radial, fisheye or fisheye_opencv");
}

/// A camera's lens and intrinsics, in units of the photo's larger side, measured from the photo's center
/// (https://opensfm.org/docs/geometry.html). In OpenSfM, the centers of the first row of pixels are at y = 0.
Camera read_camera(const LocatedJson& c) {
    const auto either = [&](const char* key, const char* other) {
        return numeral(c.at(c.has(key) ? key : other));
    };
    const Lens lens = opensfm_lens(c);
    const int width = photo_size(c.at("width")), height = photo_size(c.at("height"));
    const double side = std::max(width, height);
    Camera out;
    out.intrinsics = {width,
                      height,
                      side * either("focal_x", "focal"),
                      side * either("focal_y", "focal"),
                      width / 2.0 + side * numeral(c, "c_x", 0),
                      height / 2.0 + side * numeral(c, "c_y", 0)};
    out.lens = lens;
    return out;
}

Pose opensfm_pose(const LocatedJson& shot) {
    const Eigen::Vector3d axis = shot.at("rotation").vector();
    const double angle = axis.norm();
    Pose pose{Eigen::Matrix3d::Identity(), shot.at("translation").vector()};
    if (angle > 0) pose.R = Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
    return pose;
}

}  // namespace

CameraSet read_opensfm(const std::filesystem::path& file) {
    JsonFile json(file);
    const std::vector<LocatedJson> worlds = json.root().items(max_cameras);
    if (worlds.empty()) throw NoCamera(file.string() + ": expected a reconstruction, found none");
    std::vector<std::vector<std::pair<std::string, LocatedJson>>> shots;
    for (const LocatedJson& w : worlds) shots.push_back(w.at("shots").entries(max_cameras));
    const auto most = std::ranges::max_element(shots, {}, [](const auto& s) { return s.size(); });
    const LocatedJson& world = worlds[std::size_t(most - shots.begin())];
    CameraSet set{"OpenSfM", {}, {}};
    for (std::size_t i = 0; i < shots.size(); ++i)
        if (i != std::size_t(most - shots.begin()))
            set.warnings.push_back("reconstruction " + std::to_string(i) + ": not used, has " +
                                   std::to_string(shots[i].size()) + " photos; the largest has " +
                                   std::to_string(most->size()));
    std::map<std::string, LocatedJson> cameras;
    for (const auto& [name, camera] : world.at("cameras").entries(max_cameras)) cameras.emplace(name, camera);
    for (const auto& [photo, shot] : *most) {
        const auto camera = cameras.find(shot.at("camera").text(1000));
        if (camera == cameras.end()) shot.at("camera").fail("the name of a camera in this file");
        set.entries.push_back({photo, read_camera(camera->second), CameraSet::Unit::pixels});
        set.entries.back().camera.cam_from_world = opensfm_pose(shot);
    }
    if (set.entries.empty()) throw NoCamera(file.string() + ": expected a shot, found none");
    return set;
}

}  // namespace vantage
