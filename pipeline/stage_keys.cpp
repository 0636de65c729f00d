#include "pipeline/stage_keys.h"

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "scene/checksum.h"
#include "scene/package_writer.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

using package::PhotoState;
using package::Stage;
using package::Type;

/// How each stage works: a number goes up where a change of ours changes what the stage makes.
constexpr std::array<std::uint32_t, stage_count> versions{2, 2, 5, 4, 4, 3};

/// XXH3-64 over values, each by its bytes; so only types without padding.
class Fingerprint {
  public:
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Fingerprint& add(const T& value) {
        const auto bytes = bytes_of_one(value);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        return *this;
    }
    template <class Derived>
    Fingerprint& add(const Eigen::MatrixBase<Derived>& m) {
        for (int r = 0; r < m.rows(); ++r)
            for (int c = 0; c < m.cols(); ++c) add(double(m(r, c)));
        return *this;
    }
    Fingerprint& add(const Intrinsics& k) {
        return add(k.width).add(k.height).add(k.fx).add(k.fy).add(k.cx).add(k.cy);
    }
    Fingerprint& add(const Lens& lens) {
        add(lens.model);
        for (const double p : lens.p) add(p);
        return *this;
    }
    std::uint64_t value() const { return checksum(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

Fingerprint start(Stage stage) { return Fingerprint().add(stage).add(versions[std::size_t(stage)]); }

std::uint64_t tiles_key(const SceneKey& scene, const PhotoInput& photo, std::uint64_t file) {
    const Intrinsics& k = photo.camera.intrinsics;
    Fingerprint f = start(Stage::tiles);
    f.add(file).add(photo.decoded.width).add(photo.decoded.height).add(k.width).add(k.height);
    // The camera matters to the pixels only where they are resampled.
    if (scene.undistortion && photo.camera.lens.distorts())
        f.add(k).add(photo.camera.lens).add(scene.settings.resampling);
    return f.value();
}

template <class T>
std::uint64_t checksum_of(const std::vector<T>& values) {
    return checksum(bytes_of(values));
}

}  // namespace

const char* name(Stage stage) {
    static constexpr std::array names{"thumbnail", "tiles", "masks", "coordinates", "coverage", "samples"};
    static_assert(names.size() == stage_count);
    return names[std::size_t(stage)];
}

std::uint64_t model_checksum(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals) {
    return Fingerprint()
        .add(checksum_of(model.positions))
        .add(checksum_of(normals))
        .add(checksum_of(model.indices))
        .add(checksum_of(model.clusters))
        .value();
}

std::uint64_t pose_checksum(const Pose& pose) { return Fingerprint().add(pose.R).add(pose.t).value(); }

PhotoState stage_keys(const SceneKey& scene, const PhotoInput& photo, const Pose& pose,
                      const FileIdentity& file, const FileIdentity& stencil) {
    PhotoState s{};
    s.photo =
        Fingerprint().add(file.bytes).add(file.checksum).add(stencil.bytes).add(stencil.checksum).value();
    s.camera = Fingerprint().add(photo.camera.intrinsics).value();
    s.pose = pose_checksum(pose);
    s.model = scene.model;
    const auto key = [&](Stage stage) -> std::uint64_t& { return s.stages[std::size_t(stage)].key; };
    key(Stage::tiles) = tiles_key(scene, photo, s.photo);
    key(Stage::thumbnail) =
        start(Stage::thumbnail).add(key(Stage::tiles)).add(scene.settings.thumbnail).value();
    for (const Stage stage : {Stage::coordinates, Stage::coverage})
        key(stage) = start(stage).add(s.camera).add(s.model).add(scene.opengl).value();
    const auto from_photo_and_model = [&](Stage stage) {
        return start(stage).add(key(Stage::tiles)).add(s.camera).add(s.model).add(scene.opengl);
    };
    key(Stage::masks) = from_photo_and_model(Stage::masks)
                            .add(scene.distance)
                            .add(scene.settings.border_width)
                            .add(scene.settings.border_threshold)
                            .add(scene.reference_density)
                            .value();
    key(Stage::samples) = from_photo_and_model(Stage::samples).add(scene.reference_density).value();
    return s;
}

bool depends_on_pose(Stage stage) { return stage != Stage::tiles && stage != Stage::thumbnail; }

std::vector<std::string> settings_of(Stage stage) {
    switch (stage) {
        case Stage::tiles:
            return {"photo_size", "resampling"};
        case Stage::thumbnail:
            return {"photo_size", "resampling", "thumbnail"};
        case Stage::masks:
            return {"photo_size",   "distance",         "render_by",
                    "border_width", "border_threshold", "cluster_triangles"};
        case Stage::coordinates:
        case Stage::coverage:
            return {"photo_size", "render_by", "cluster_triangles"};
        case Stage::samples:
            return {"photo_size", "resampling", "render_by", "cluster_triangles"};
        case Stage::count:
            break;
    }
    return {};
}

std::vector<std::pair<Type, std::uint32_t>> chunks_of(Stage stage, int levels) {
    std::vector<std::pair<Type, std::uint32_t>> chunks;
    switch (stage) {
        case Stage::thumbnail:
            return {{Type::thumbnail, 0}};
        case Stage::tiles:
            for (int l = 0; l < levels; ++l) chunks.push_back({Type::tiles, std::uint32_t(l)});
            return chunks;
        case Stage::masks:
            for (int l = mask_level; l < mask_levels_end(levels); ++l) {
                chunks.push_back({Type::masks, std::uint32_t(l)});
                chunks.push_back({Type::depth, std::uint32_t(l)});
            }
            return chunks;
        case Stage::coordinates:
            return {{Type::coordinates, 0}};
        case Stage::coverage:
            return {{Type::coverage, 0}, {Type::visible, 0}};
        case Stage::samples:
            return {{Type::samples, 0}};
        case Stage::count:
            break;
    }
    return chunks;
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
