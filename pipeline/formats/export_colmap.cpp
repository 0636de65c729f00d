#include "pipeline/formats/export_colmap.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <sstream>

#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "pipeline/formats/camera_axes.h"
#include "scene/package/output_file.h"

namespace vantage {
namespace {

/// The first model with two focal lengths that has the lens and its coefficients; null if there is none.
const ColmapModel* model_of(const Lens& lens) {
    const LensModel wanted = lens.distorts() ? lens.model : LensModel::none;
    const auto used =
        lens.p.rend() - std::find_if(lens.p.rbegin(), lens.p.rend(), [](double v) { return v != 0; });
    for (const ColmapModel& m : colmap_models())
        if (m.lens == wanted && m.focal_center == std::array{0, 1, 2, 3} && used <= std::ssize(m.distortion))
            return &m;
    return nullptr;
}

std::string camera_line(std::size_t id, const NamedCamera& photo) {
    const Intrinsics& k = photo.camera.intrinsics;
    const ColmapModel* model = model_of(photo.camera.lens);
    if (!model)
        throw Error(Exit::input, fmt::format("{}: COLMAP has no lens model \"{}\"", photo.photo,
                                             name(photo.camera.lens.model)));
    std::string line =
        fmt::format("{} {} {} {} {} {} {} {}", id, model->name, k.width, k.height, k.fx, k.fy, k.cx, k.cy);
    for (std::size_t i = 0; i < model->distortion.size(); ++i)
        line += fmt::format(" {}", photo.camera.lens.p[i]);
    return line + "\n";
}

std::string image_line(std::size_t id, const NamedCamera& photo) {
    const Eigen::Quaterniond q(photo.camera.cam_from_world.R);
    const Eigen::Vector3d& t = photo.camera.cam_from_world.t;
    return fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", id, q.w(), q.x(), q.y(), q.z(), t.x(), t.y(),
                       t.z(), id, photo.photo);
}

}  // namespace

bool has_colmap_model(const Lens& lens) { return model_of(lens) != nullptr; }

void write_colmap_text(const std::filesystem::path& folder, std::span<const NamedCamera> photos,
                       const std::string& comment) {
    make_folder(folder);
    std::ostringstream cameras, images, points;
    cameras << cameras_mark << comment << "# CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]\n";
    images << cameras_mark << comment
           << "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then the image's points (none)\n";
    points << cameras_mark << comment << "# POINT3D_ID X Y Z R G B ERROR TRACK[] (no points)\n";
    for (std::size_t i = 0; i < photos.size(); ++i) {
        cameras << camera_line(i + 1, photos[i]);
        images << image_line(i + 1, photos[i]);
    }
    const std::string_view texts[] = {cameras.view(), images.view(), points.view()};
    for (std::size_t i = 0; i < std::size(texts); ++i) replace_file(folder / colmap_text_files[i], texts[i]);
}

}  // namespace vantage
