#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <optional>

#include "base/text/error.h"
#include "base/values/nearest_rotation.h"
#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/json_file.h"

namespace vantage {
namespace {

/// The frame's own value if there is one, otherwise the common value of all frames.
std::optional<LocatedJson> value_of(const LocatedJson& frame, const LocatedJson& all, const char* key) {
    if (frame.has(key)) return frame.at(key);
    return all.has(key) ? std::optional(all.at(key)) : std::nullopt;
}

/// An affine map, given as 3 or 4 rows of 4 numbers.
Eigen::Matrix4d affine(const LocatedJson& matrix) {
    const std::vector<LocatedJson> rows = matrix.items(4);
    if (rows.size() < 3) matrix.fail("3 or 4 rows of 4 numbers");
    Eigen::Matrix4d out = Eigen::Matrix4d::Identity();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<double> row = numerals(rows[i], 4);
        for (std::size_t j = 0; j < 4; ++j) out(Eigen::Index(i), Eigen::Index(j)) = row[j];
    }
    return out;
}

/// The first of these values that is not 0.
double first_given(std::initializer_list<double> values) {
    const auto given = std::ranges::find_if(values, [](double v) { return v != 0; });
    return given == values.end() ? 0 : *given;
}

class Frames {
  public:
    explicit Frames(const LocatedJson& all) : all_(all) {
        if (all.has("applied_transform")) original_ = affine(all.at("applied_transform"));
        if (std::abs(original_.determinant()) < 1e-9) all.at("applied_transform").fail("an invertible map");
        original_ = original_.inverse().eval();
        if (numeral(all, "applied_scale", 1) != 1) all.at("applied_scale").fail("no scale, or 1");
    }
    CameraSet::Entry read(const LocatedJson& frame) const {
        CameraSet::Entry entry{frame.at("file_path").text(10000), {}, CameraSet::Unit::pixels};
        set_intrinsics(frame, entry);
        entry.camera.lens = lens_of(frame);
        const Eigen::Matrix4d m = original_ * affine(frame.at("transform_matrix"));
        entry.camera.cam_from_world =
            from_camera_to_world(backward(m.topLeftCorner<3, 3>()), m.topRightCorner<3, 1>());
        return entry;
    }
    /// The transform from the file's frame to the original one, with the rotation and scale of the affine
    /// map.
    Similarity transform() const {
        const Eigen::Matrix3d m = original_.topLeftCorner<3, 3>();
        return {nearest_orthogonal(m), original_.topRightCorner<3, 1>(),
                std::cbrt(std::abs(m.determinant()))};
    }

  private:
    double number(const LocatedJson& frame, const char* key, double otherwise) const {
        const auto v = value_of(frame, all_, key);
        return v ? numeral(*v) : otherwise;
    }
    /// The focal length from a field of view, as a fraction of the photo's side; 0 if not given.
    double focal_of_angle(const LocatedJson& frame, const char* key) const {
        const double angle = number(frame, key, 0);
        return angle > 0 && angle < std::numbers::pi ? 0.5 / std::tan(angle / 2) : 0;
    }
    void set_intrinsics(const LocatedJson& frame, CameraSet::Entry& entry) const {
        Intrinsics& k = entry.camera.intrinsics;
        const auto w = value_of(frame, all_, "w"), h = value_of(frame, all_, "h");
        const double fl_x = number(frame, "fl_x", 0), fl_y = number(frame, "fl_y", 0);
        if (w && h) {
            k.width = photo_size(*w);
            k.height = photo_size(*h);
            const double across = focal_of_angle(frame, "camera_angle_x") * k.width,
                         down = focal_of_angle(frame, "camera_angle_y") * k.height;
            k.fx = first_given({fl_x, across, fl_y, down});
            k.fy = first_given({fl_y, fl_x, down, k.fx});
            k.cx = number(frame, "cx", k.width / 2.0);
            k.cy = number(frame, "cy", k.height / 2.0);
        } else if (fl_x != 0 || fl_y != 0) {
            k.fx = first_given({fl_x, fl_y});
            k.fy = first_given({fl_y, fl_x});
            set_center_of_photo(frame, entry);
        } else {
            entry.unit = CameraSet::Unit::photo_width;
            k.fx = k.fy = focal_of_angle(frame, "camera_angle_x");
        }
        if (!(k.fx > 0)) fail_of_focal_length(frame);
    }
    [[noreturn]] void fail_of_focal_length(const LocatedJson& frame) const {
        for (const char* key : {"camera_angle_x", "camera_angle_y"})
            if (const auto angle = value_of(frame, all_, key); angle && focal_of_angle(frame, key) == 0)
                angle->fail("an angle in radians, above 0 and below pi");
        for (const char* key : {"fl_x", "fl_y"})
            if (const auto focal = value_of(frame, all_, key); focal && !(numeral(*focal) > 0))
                focal->fail("a focal length above 0");
        frame.fail("a focal length, fl_x or camera_angle_x");
    }
    /// Sets the principal point of a photo of unknown size.
    void set_center_of_photo(const LocatedJson& frame, CameraSet::Entry& entry) const {
        const auto cx = value_of(frame, all_, "cx"), cy = value_of(frame, all_, "cy");
        entry.unit = cx && cy ? CameraSet::Unit::pixels_from_corner : CameraSet::Unit::pixels_from_center;
        if (!cx || !cy) return;
        entry.camera.intrinsics.cx = numeral(*cx);
        entry.camera.intrinsics.cy = numeral(*cy);
    }
    Lens lens_of(const LocatedJson& frame) const {
        const auto c = [&](const char* key) { return number(frame, key, 0); };
        const auto model = value_of(frame, all_, "camera_model");
        const std::string name = model ? model->text(100) : "OPENCV";
        const auto fisheye = value_of(frame, all_, "is_fisheye");
        if (name == "OPENCV_FISHEYE" || (fisheye && fisheye->is_true()))
            return {LensModel::fisheye, {c("k1"), c("k2"), c("k3"), c("k4")}};
        if (name == "PINHOLE" || name == "SIMPLE_PINHOLE") return {};
        if (name != "OPENCV" && name != "SIMPLE_RADIAL" && name != "RADIAL")
            model->fail("OPENCV, OPENCV_FISHEYE, PINHOLE, SIMPLE_PINHOLE, SIMPLE_RADIAL or RADIAL");
        return brown_lens({c("k1"), c("k2"), c("k3"), c("k4")}, c("p1"), c("p2"), 0);
    }

    LocatedJson all_;
    Eigen::Matrix4d original_ = Eigen::Matrix4d::Identity();  ///< affine map from the file's frame
};

}  // namespace

CameraSet read_transforms(const std::filesystem::path& file) {
    JsonFile json(file);
    const LocatedJson all = json.root();
    const Frames frames(all);
    CameraSet set{"transforms.json", {}, {}};
    set.transform = frames.transform();
    std::map<std::string, Eigen::Matrix3d> seen;
    for (const LocatedJson& frame : all.at("frames").items(max_cameras)) {
        CameraSet::Entry entry = frames.read(frame);
        const auto [other, first] = seen.emplace(entry.photo, entry.camera.cam_from_world.R);
        if (first)
            set.entries.push_back(std::move(entry));
        else if (other->second == entry.camera.cam_from_world.R)
            set.warnings.push_back(entry.photo + ": listed twice");
        else
            frame.fail("one frame per photo");
    }
    if (set.entries.empty()) throw NoCamera(file.string() + ": expected a frame, found none");
    return set;
}

}  // namespace vantage
