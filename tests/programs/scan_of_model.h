#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/formats/export_colmap.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/synth/cast_photo.h"
#include "pipeline/synth/synthesize.h"

namespace vantage {

/// The color of a photo's pixel that does not show the model.
using BesideModel = std::function<std::array<std::uint8_t, 3>(int x, int y)>;

/// Writes a scan of this model into a folder. Its photos are made with one ray per pixel. By default,
/// all photos show the model. If `worlds` are given, the photos are divided into equally large consecutive
/// groups, and each group shows one of the worlds.
inline void write_scan(const std::filesystem::path& folder, const SynthModel& model,
                       const std::vector<Camera>& cameras, const BesideModel& beside = {},
                       const std::vector<SynthModel>& worlds = {}) {
    std::filesystem::create_directories(folder / "images");
    const RayScene rays(model.mesh);
    std::vector<NamedCamera> photos;
    std::vector<RayScene> rays_of_worlds;
    for (const SynthModel& w : worlds) rays_of_worlds.emplace_back(w.mesh);
    for (const Camera& camera : cameras) {
        const std::size_t w = photos.size() * worlds.size() / cameras.size();
        photos.push_back({"photo" + std::to_string(photos.size()) + ".png", camera});
        std::vector<std::uint8_t> rgb = worlds.empty() ? cast_photo(model, rays, camera, 1)
                                                       : cast_photo(worlds[w], rays_of_worlds[w], camera, 1);
        const std::vector<float> z = cast_depth(rays, camera);
        const int width = camera.intrinsics.width;
        for (std::size_t i = 0; i < z.size() && beside; ++i)
            if (!std::isfinite(z[i])) std::ranges::copy(beside(int(i) % width, int(i) / width), &rgb[3 * i]);
        image_files().write(folder / "images" / photos.back().photo, width, camera.intrinsics.height, 3,
                            Sample::u8, std::as_bytes(std::span(rgb)));
    }
    write_colmap_text(folder / "sparse", photos);
    std::vector<Eigen::Vector3f> positions;
    for (const Eigen::Vector3d& p : model.mesh.positions) positions.push_back(p.cast<float>());
    write_ply(folder / "mesh.ply",
              {.positions = positions, .normals = model.mesh.normals, .triangles = model.mesh.triangles});
}

}  // namespace vantage
