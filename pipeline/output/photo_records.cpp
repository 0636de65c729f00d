#include "pipeline/output/photo_records.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>

#include "base/files/checksum.h"
#include "base/text/error.h"
#include "base/text/photo_names.h"
#include "pipeline/photos/reduced.h"

namespace vantage {

namespace {

package::PhotoRecord photo_record(const PhotoInput& photo, const Eigen::Vector3d& origin, int thumbnail,
                                  bool held_out) {
    package::PhotoRecord r{};
    if (photo.name.size() >= sizeof r.name)
        throw Error(Exit::input,
                    photo.name + ": name is longer than " + std::to_string(sizeof r.name - 1) + " bytes");
    std::memcpy(r.name, photo.name.data(), photo.name.size());
    const Intrinsics& k = photo.camera.intrinsics;
    r.width = std::uint32_t(k.width);
    r.height = std::uint32_t(k.height);
    r.flags = held_out ? std::uint32_t(package::photo_held_out) : 0;
    r.levels = held_out ? 0 : std::uint32_t(level_count(k.width, k.height));
    const Level small = thumbnail_size(k.width, k.height, thumbnail),
                half = level_size(k.width, k.height, weight_map_level);
    r.thumbnail_width = std::uint32_t(small.width);
    r.thumbnail_height = std::uint32_t(small.height);
    r.weight_map_width = std::uint32_t(half.width);
    r.weight_map_height = std::uint32_t(half.height);
    r.fx = k.fx, r.fy = k.fy, r.cx = k.cx, r.cy = k.cy;
    set_pose(photo.camera.cam_from_world.relative_to(origin), r);
    for (double& g : r.gain) g = 1;
    return r;
}

}  // namespace

std::vector<bool> held_out(const SceneInput& scene, std::span<const std::string> wanted) {
    std::vector<std::string_view> names;
    for (const PhotoInput& photo : scene.photos) names.emplace_back(photo.name);
    std::vector<bool> held(names.size(), false);
    for (const std::string& name : wanted) {
        const std::vector<std::size_t> meant = photos_meant(names, name);
        if (meant.empty()) throw Error(Exit::usage, "--hold-out " + name + ": the scene has no such photo");
        if (meant.size() > 1)
            throw Error(Exit::usage,
                        "--hold-out " + name + ": ambiguous, expected one of " + listed(names, meant));
        held[meant.front()] = true;
    }
    return held;
}

std::vector<package::PhotoRecord> photo_records(const SceneInput& scene, const PrepareSettings& settings,
                                                const Eigen::Vector3d& origin) {
    const std::vector<bool> held = held_out(scene, settings.hold_out);
    std::vector<package::PhotoRecord> records;
    for (std::size_t i = 0; i < scene.photos.size(); ++i)
        records.push_back(photo_record(scene.photos[i], origin, settings.thumbnail, held[i]));
    if (!held.empty() && std::ranges::all_of(held, std::identity{}))
        throw Error(Exit::usage, "--hold-out: all " + std::to_string(records.size()) +
                                     " photos are held out, expected at least one that is not");
    return records;
}

std::uint64_t names_checksum(std::span<const package::PhotoRecord> photos) {
    std::string names;
    for (const package::PhotoRecord& p : photos) names += std::string(p.name) + '\n';
    return checksum(std::as_bytes(std::span(names)));
}

}  // namespace vantage
