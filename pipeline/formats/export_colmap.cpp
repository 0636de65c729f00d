#include "pipeline/formats/export_colmap.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <sstream>

#include "files/make_folder.h"
#include "files/output_file.h"
#include "scene/error.h"
#include "scene/replace_file.h"

namespace vantage {
namespace {

std::string camera_line(std::size_t id, const NamedCamera& photo) {
    const Intrinsics& k = photo.camera.intrinsics;
    const Lens& lens = photo.camera.lens;
    const bool four_terms = lens.p[4] == 0 && lens.p[5] == 0 && lens.p[6] == 0 && lens.p[7] == 0;
    const std::string pinhole = fmt::format("{} {} {} {} {} {}", k.width, k.height, k.fx, k.fy, k.cx, k.cy);
    if (!lens.distorts()) return fmt::format("{} PINHOLE {}\n", id, pinhole);
    if (lens.model != LensModel::opencv || !four_terms)
        throw Error(Exit::input,
                    photo.photo + ": COLMAP text is written only for OPENCV lenses with at most four terms");
    return fmt::format("{} OPENCV {} {} {} {} {}\n", id, pinhole, lens.p[0], lens.p[1], lens.p[2], lens.p[3]);
}

std::string image_line(std::size_t id, const NamedCamera& photo) {
    const Eigen::Quaterniond q(photo.camera.cam_from_world.R);
    const Eigen::Vector3d& t = photo.camera.cam_from_world.t;
    return fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", id, q.w(), q.x(), q.y(), q.z(), t.x(), t.y(),
                       t.z(), id, photo.photo);
}

}  // namespace

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
