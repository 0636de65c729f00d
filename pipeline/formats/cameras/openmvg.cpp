#include <array>
#include <map>

#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/json_file.h"
#include "pipeline/formats/skipped_cameras.h"

namespace vantage {
namespace {

/// A type of camera: the key and number of its coefficients.
struct OpenmvgModel {
    const char *name, *key;
    std::size_t count;
};
constexpr OpenmvgModel openmvg_models[] = {{"pinhole", nullptr, 0},
                                           {"pinhole_radial_k1", "disto_k1", 1},
                                           {"pinhole_radial_k3", "disto_k3", 3},
                                           {"pinhole_brown_t2", "disto_t2", 5},
                                           {"fisheye", "fisheye", 4}};

Lens lens_of(const OpenmvgModel& m, const LocatedJson& data) {
    if (m.count == 0) return {};
    const std::vector<double> c = numerals(data.at(m.key), m.count);
    if (m.count == 4) return {LensModel::fisheye, {c[0], c[1], c[2], c[3]}};
    std::array<double, 4> radial{};
    for (std::size_t i = 0; i < std::min<std::size_t>(m.count, 3); ++i) radial[i] = c[i];
    return brown_lens(radial, m.count == 5 ? c[3] : 0, m.count == 5 ? c[4] : 0, 0);
}

/// The archive names a type only where it is first used; there, the highest bit of the type's number is set.
class TypeNames {
  public:
    std::string of(const LocatedJson& value) {
        const auto number = std::uint32_t(value.at("polymorphic_id").number(0, 4294967295.0));
        std::string& name = names_[number & 0x7fffffff];
        if (value.has("polymorphic_name")) name = value.at("polymorphic_name").text(100);
        return name;
    }

  private:
    std::map<std::uint32_t, std::string> names_;
};

Camera read_intrinsic(const LocatedJson& value, const std::string& name) {
    const auto model =
        std::ranges::find(openmvg_models, name, [](const OpenmvgModel& m) { return std::string(m.name); });
    if (model == std::end(openmvg_models))
        value.at("polymorphic_id").fail("a perspective or fisheye camera, not '" + name + "'");
    const LocatedJson data = value.at("ptr_wrapper").at("data");
    const LocatedJson pinhole = data.has("value0") ? data.at("value0") : data;
    Camera c;
    const double f = numeral(pinhole.at("focal_length"));
    const std::vector<double> center = numerals(pinhole.at("principal_point"), 2);
    // The center of the first pixel is at 0.
    c.intrinsics = {photo_size(pinhole.at("width")),
                    photo_size(pinhole.at("height")),
                    f,
                    f,
                    center[0] + 0.5,
                    center[1] + 0.5};
    c.lens = lens_of(*model, data);
    return c;
}

Pose openmvg_pose(const LocatedJson& value) {
    Pose pose;
    const std::vector<LocatedJson> rows = value.at("rotation").items(3);
    if (rows.size() != 3) value.at("rotation").fail("3 rows");
    for (int i = 0; i < 3; ++i) {
        const std::vector<double> row = numerals(rows[std::size_t(i)], 3);
        pose.R.row(i) = Eigen::RowVector3d(row[0], row[1], row[2]);
    }
    pose.t = -pose.R * value.at("center").vector();
    return pose;
}

}  // namespace

CameraSet read_openmvg(const std::filesystem::path& file) {
    JsonFile json(file);
    const LocatedJson root = json.root();
    std::map<std::string, std::pair<LocatedJson, std::string>> cameras;  // and the names of their types
    std::map<std::string, Pose> poses;
    TypeNames names;
    for (const LocatedJson& i : root.at("intrinsics").items(max_cameras))
        cameras.emplace(identifier(i.at("key")), std::pair(i.at("value"), names.of(i.at("value"))));
    for (const LocatedJson& e : root.at("extrinsics").items(max_cameras))
        poses[identifier(e.at("key"))] = openmvg_pose(e.at("value"));
    CameraSet set{"OpenMVG", {}, {}};
    SkippedCameras skipped;
    for (const LocatedJson& v : root.at("views").items(max_cameras)) {
        const LocatedJson view = v.at("value").at("ptr_wrapper").at("data");
        const std::string folder = view.has("local_path") ? view.at("local_path").text(10000) : "",
                          photo = (std::filesystem::path(folder) / view.at("filename").text(10000)).string();
        const auto pose = poses.find(identifier(view.at("id_pose")));
        const auto camera = cameras.find(identifier(view.at("id_intrinsic")));
        if (pose == poses.end() || camera == cameras.end()) {
            skipped.add(photo, pose == poses.end() ? "no pose" : "no intrinsics");
            continue;
        }
        const auto& [intrinsic, type] = camera->second;
        set.entries.push_back({photo, read_intrinsic(intrinsic, type), CameraSet::Unit::pixels});
        set.entries.back().camera.cam_from_world = pose->second;
    }
    skipped.tell(set.warnings);
    if (set.entries.empty()) skipped.fail(file);
    return set;
}

}  // namespace vantage
