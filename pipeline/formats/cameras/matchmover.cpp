#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/xml_file.h"

namespace vantage {
namespace {

/// The camera-to-world rotation Rz Ry Rx from angles in degrees, with z backward.
Eigen::Matrix3d matchmover_rotation(const XmlFile& file, pugi::xml_node frame) {
    const pugi::xml_node r = frame.child("R");
    const auto turn = [&](const char* name, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(file.attribute(r, name, 0) * std::numbers::pi / 180, axis);
    };
    return (turn("z", Eigen::Vector3d::UnitZ()) * turn("y", Eigen::Vector3d::UnitY()) *
            turn("x", Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

/// The camera of a frame. If the frame has values of its own, they replace all values of the camera's
/// description.
Camera read_frame(const XmlFile& file, pugi::xml_node shot, pugi::xml_node frame) {
    Camera c;
    Intrinsics& k = c.intrinsics;
    k.width = file.size(shot, file.attribute(shot, "w"));
    k.height = file.size(shot, file.attribute(shot, "h"));
    const double field = file.attribute(frame, "fovx") * std::numbers::pi / 180;
    if (!(field > 0 && field < std::numbers::pi)) file.fail(frame, "fovx between 0 and 180", "another angle");
    k.fx = k.width / (2 * std::tan(field / 2));
    k.fy = k.fx * file.attribute(frame, "pr", 1);
    k.cx = k.width * file.attribute(frame, "ppx", 0.5);
    k.cy = k.height * file.attribute(frame, "ppy", 0.5);
    if (!(k.fy > 0)) file.fail(frame, "pr above 0", "another ratio");
    if (const double rd = file.attribute(frame, "rd", 0); rd != 0) c.lens = {LensModel::matchmover, {rd}};
    const pugi::xml_node t = frame.child("T");
    const Eigen::Vector3d center(file.attribute(t, "x", 0), file.attribute(t, "y", 0),
                                 file.attribute(t, "z", 0));
    c.cam_from_world = from_camera_to_world(backward(matchmover_rotation(file, frame)), center);
    return c;
}

/// The file of a frame: @ is replaced with the frame's number, and each # in a run with one of its digits.
std::string photo_name(std::string pattern, long number) {
    std::string digits = std::to_string(number);
    std::size_t at = pattern.rfind('@'), length = 1;
    if (at == pattern.npos) {
        const std::size_t last = pattern.rfind('#');
        if (last == pattern.npos) return pattern;
        at = pattern.find_last_not_of('#', last) + 1;
        length = last + 1 - at;
        if (digits.size() < length) digits.insert(0, length - digits.size(), '0');
    }
    return pattern.replace(at, length, digits);
}

void read_shot(const XmlFile& file, pugi::xml_node shot, CameraSet& set) {
    const pugi::xml_node images = shot.child("IPLN");
    const std::string pattern = images.attribute("img").value();
    if (pattern.empty()) file.fail(shot, "<IPLN img=...>, the photos", "none");
    const long first = std::lround(file.attribute(images, "b", 0));
    for (const pugi::xml_node frame : shot.children("CFRM")) {
        const long time = std::lround(file.attribute(frame, "t", 0));
        set.entries.push_back({photo_name(pattern, first + time), read_frame(file, shot, frame)});
    }
}

}  // namespace

CameraSet read_matchmover(const std::filesystem::path& path) {
    const XmlFile file(path);
    const pugi::xml_node root = file.child("RZML");
    if (!root) throw Error(Exit::input, path.string() + ": expected RZML of MatchMover or ImageModeler");
    CameraSet set{"MatchMover", {}, {}};
    for (const pugi::xml_node shot : root.children("SHOT")) read_shot(file, shot, set);
    if (set.entries.empty())
        throw NoCamera(path.string() + ": expected a SHOT with a CFRM (the camera of a frame), found none");
    return set;
}

}  // namespace vantage
