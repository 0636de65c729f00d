#include "pipeline/output/stage_keys.h"

#include <cstddef>

#include "base/values/bytes_of.h"

namespace vantage {
namespace {

using package::PhotoState;
using package::Stage;

/// Incremented whenever a change to the code changes the colors of photos that have a color profile.
constexpr std::uint32_t color_conversion = 1;

/// Starts the key of a stage. Compact chunks need other keys: their bytes differ, and the depth and colors
/// that other stages read are rounded.
Fingerprint start(const StageRow& row, const SceneKey& scene) {
    Fingerprint f;
    f.add(row.stage).add(row.version);
    if (scene.compact) f.add(scene.compact);
    return f;
}

std::uint64_t tiles_key(const SceneKey& scene, const PhotoInput& photo, std::uint64_t file) {
    const Intrinsics& k = photo.camera.intrinsics;
    Fingerprint f = start(stage_row(Stage::tiles), scene);
    f.add(file).add(photo.decoded.width).add(photo.decoded.height).add(k.width).add(k.height);
    if (photo.profile.converts) f.add(color_conversion);
    return f.value();
}

template <class T>
std::uint64_t checksum_of(const std::vector<T>& values) {
    return checksum(bytes_of(values));
}

}  // namespace

std::uint64_t model_checksum(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals) {
    Fingerprint f;
    f.add(checksum_of(model.positions))
        .add(checksum_of(normals))
        .add(checksum_of(model.indices))
        .add(checksum_of(model.clusters));
    if (model.opaque.clusters < model.clusters.size()) f.add(model.opaque.triangles);
    return f.value();
}

std::uint64_t pose_checksum(const Pose& pose) { return Fingerprint().add(pose.R).add(pose.t).value(); }

PhotoState stage_keys(const SceneKey& scene, const PhotoInput& photo, const Pose& pose,
                      const FileIdentity& file, const FileIdentity& mask) {
    PhotoState s{};
    s.photo = Fingerprint().add(file.bytes).add(file.checksum).add(mask.bytes).add(mask.checksum).value();
    Fingerprint camera;
    camera.add(photo.camera.intrinsics);
    if (scene.undistortion && photo.camera.lens.distorts()) camera.add(photo.camera.lens);
    s.camera = camera.value();
    s.pose = pose_checksum(pose);
    s.model = scene.model;
    const std::uint64_t tiles = tiles_key(scene, photo, s.photo);
    for (const StageRow& row : stage_table()) {
        Fingerprint f = start(row, scene);
        if (row.pixels != PixelInput::none) f.add(tiles);
        if (row.model) f.add(s.camera).add(s.model).add(scene.opengl);
        if (row.key) row.key(f, scene);
        s.stages[std::size_t(row.stage)].key = row.stage == Stage::tiles ? tiles : f.value();
    }
    return s;
}

void seal(PhotoState& state, const package::PhotoRecord& record) {
    state.record = checksum(bytes_of_one(record));
    state.checksum = checksum(bytes_of_one(state).first(offsetof(PhotoState, checksum)));
}

bool sealed(const PhotoState& state, const package::PhotoRecord& record) {
    PhotoState expected = state;
    seal(expected, record);
    return expected.record == state.record && expected.checksum == state.checksum;
}

}  // namespace vantage
