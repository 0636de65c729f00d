#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "base/values/quantile.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "scene/package/package_reader.h"

namespace vantage {

inline SceneInput scene_with_cameras(const std::filesystem::path& folder,
                                     const std::filesystem::path& cameras) {
    InputFiles files = discover(folder);
    files.cameras = cameras;
    return read_scene(files);
}

/// For each photo, the median distance in pixels between the projections by the package's camera and by the
/// true camera, over all visible vertices of the model.
inline std::vector<double> camera_errors(const PackageReader& package, const SceneInput& truth) {
    const auto vertices = package.records<Eigen::Vector3f>(package::Type::positions);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    const Eigen::Vector3d origin(package.scene().origin);
    std::vector<double> out;
    for (const PhotoInput& photo : truth.photos) {
        const std::uint32_t i = *package.photo_index(photo.name);
        const Intrinsics k = intrinsics(package.photos()[i]);
        const Pose now = cam_from_origin(package.photos()[i]),
                   right = photo.camera.cam_from_world.relative_to(origin);
        const auto bits = package.records<std::uint64_t>(package::Type::visible, i);
        std::vector<bool> seen(vertices.size());
        for (std::size_t k = 0; k < indices.size(); ++k)
            if (bits[k / 3 / 64] >> (k / 3 % 64) & 1) seen[indices[k]] = true;
        std::vector<double> off;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            if (!seen[v]) continue;
            const Eigen::Vector3d x = vertices[v].cast<double>();
            const auto a = project(k, now, x), b = project(k, right, x);
            if (a && b) off.push_back((a->pixel - b->pixel).norm());
        }
        out.push_back(quantile(std::move(off), 0.5));
    }
    return out;
}

}  // namespace vantage
