#include "player/photo_block.h"

#include <string>

#include "scene/error.h"
#include "scene/package_reader.h"

namespace vantage {
namespace {

PhotoBlock block_of(const package::PhotoRecord& p) {
    PhotoBlock b{};
    const Pose pose = cam_from_origin(p);
    const Eigen::Vector3d center = pose.center();
    Eigen::Map<Eigen::Matrix4f> m(b.cam_from_origin);
    m.setIdentity();
    m.topLeftCorner<3, 3>() = pose.R.cast<float>();
    m.topRightCorner<3, 1>() = pose.t.cast<float>();
    const double intrinsics[] = {p.fx, p.fy, p.cx, p.cy};
    for (int i = 0; i < 4; ++i) b.focal_center[i] = float(intrinsics[i]);
    b.size_weight[0] = float(p.width);
    b.size_weight[1] = float(p.height);
    b.size_weight[2] = float(p.levels);
    for (int i = 0; i < 3; ++i) {
        b.center_hull[i] = float(center[i]);
        b.direction[i] = float(p.corrected_direction[i]);
    }
    b.center_hull[3] = float(p.hull_area);
    return b;
}

}  // namespace

PhotoBlocks lay_out_photos(std::span<const package::PhotoRecord> photos) {
    PhotoBlocks out;
    for (const package::PhotoRecord& p : photos) {
        if (p.levels > most_levels)
            throw Error(Exit::damaged, std::string(p.name) + ": has " + std::to_string(p.levels) +
                                           " levels, expected at most 12");
        PhotoBlock b = block_of(p);
        for (std::uint32_t l = 0; l < p.levels; ++l) {
            b.level_base[l] = out.color_pages;
            out.color_pages += std::uint32_t(level_size(int(p.width), int(p.height), int(l)).tiles());
        }
        b.mask_base = out.mask_pages;
        if (p.levels)
            out.mask_pages += std::uint32_t(level_size(int(p.width), int(p.height), mask_level).tiles());
        out.blocks.push_back(b);
    }
    return out;
}

}  // namespace vantage
