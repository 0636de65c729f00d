#include "pipeline/formats/export_colmap.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>
#include <utility>

#include "files/make_folder.h"
#include "files/output_file.h"
#include "scene/error.h"
#include "scene/replace_file.h"

namespace vantage {
namespace {

/// A model and how many of Lens::p it takes, in their order; no name if COLMAP has no such model.
std::pair<const char*, std::size_t> model_of(const Lens& lens) {
    const auto all = coefficient_names(lens.model).size();
    switch (lens.model) {
        case LensModel::none:
            return {"PINHOLE", 0};
        case LensModel::opencv:
            if (!lens.distorts()) return {"PINHOLE", 0};
            return std::any_of(&lens.p[4], &lens.p[8], [](double v) { return v != 0; })
                       ? std::pair("FULL_OPENCV", all)
                       : std::pair("OPENCV", std::size_t(4));
        case LensModel::fisheye:
            return {"OPENCV_FISHEYE", all};
        case LensModel::fov:
            return {"FOV", all};
        case LensModel::thin_prism:
            return {"THIN_PRISM_FISHEYE", all};
        case LensModel::aria:
            return {"RAD_TAN_THIN_PRISM_FISHEYE", all};
        case LensModel::division:
            return {"DIVISION", all};
        case LensModel::unified:
            return {"EUCM", all};
        case LensModel::brown:
        case LensModel::matchmover:
            return {nullptr, 0};
    }
    return {nullptr, 0};
}

std::string camera_line(std::size_t id, const NamedCamera& photo) {
    const Intrinsics& k = photo.camera.intrinsics;
    const auto [model, count] = model_of(photo.camera.lens);
    if (!model)
        throw Error(Exit::input, fmt::format("{}: COLMAP has no lens model \"{}\"", photo.photo,
                                             name(photo.camera.lens.model)));
    std::string line =
        fmt::format("{} {} {} {} {} {} {} {}", id, model, k.width, k.height, k.fx, k.fy, k.cx, k.cy);
    for (std::size_t i = 0; i < count; ++i) line += fmt::format(" {}", photo.camera.lens.p[i]);
    return line + "\n";
}

std::string image_line(std::size_t id, const NamedCamera& photo) {
    const Eigen::Quaterniond q(photo.camera.cam_from_world.R);
    const Eigen::Vector3d& t = photo.camera.cam_from_world.t;
    return fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", id, q.w(), q.x(), q.y(), q.z(), t.x(), t.y(),
                       t.z(), id, photo.photo);
}

}  // namespace

bool has_colmap_model(const Lens& lens) { return model_of(lens).first != nullptr; }

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
