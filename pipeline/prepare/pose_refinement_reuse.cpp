#include "pipeline/prepare/pose_refinement_reuse.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/files/checksum.h"
#include "base/values/bytes_of.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/photo_records.h"
#include "scene/package/valid_records.h"

namespace vantage {
namespace {

using package::PairRecord;
using package::PhotoRecord;
using package::PhotoState;
using package::PoseRefinementRecord;
using package::Stage;
using package::Type;

/// Incremented whenever a change to the code changes the result of pose refinement.
constexpr std::uint64_t version = 2;

std::uint64_t hash(std::span<const std::uint64_t> values) { return checksum(std::as_bytes(values)); }

}  // namespace

std::vector<Pose> given_poses(const SceneInput& scene, const Eigen::Vector3d& origin) {
    std::vector<Pose> out;
    for (const PhotoInput& p : scene.photos) out.push_back(p.camera.cam_from_world.relative_to(origin));
    return out;
}

std::vector<Pose> given_poses(const PackageReader& package) {
    std::vector<Pose> out;
    const auto given = valid_records<PoseRefinementRecord>(package, Type::pose_refinement);
    const auto photos = valid_records<PhotoRecord>(package, Type::photos);
    for (std::size_t i = 0; i < photos.size(); ++i)
        out.push_back(i < given.size() ? cam_from_origin(given[i]) : cam_from_origin(photos[i]));
    return out;
}

std::vector<std::uint64_t> pose_refinement_fingerprints(std::span<const PhotoState> states,
                                                        std::span<const PhotoRecord> photos,
                                                        std::span<const Pose> given, bool opengl) {
    std::vector<std::uint64_t> out;
    for (std::size_t i = 0; i < states.size(); ++i) {
        out.push_back(
            hash(std::array{states[i].stages[std::size_t(Stage::tiles)].key, states[i].camera,
                            states[i].model, pose_checksum(given[i]), std::uint64_t(opengl), version}));
        if (photos[i].image_set)
            out.back() = hash(std::array{out.back(), std::uint64_t(photos[i].image_set)});
    }
    return out;
}

std::uint64_t pose_refinement_key(std::span<const std::uint64_t> fingerprints, EffectChoice choice,
                                  bool validate) {
    return hash(std::array{hash(fingerprints), std::uint64_t(choice), std::uint64_t(validate), version});
}

std::optional<PoseRefinement> pose_refinement_of(const PackageReader& package, std::uint64_t key) {
    const auto records = valid_records<PoseRefinementRecord>(package, Type::pose_refinement);
    const auto photos = valid_records<PhotoRecord>(package, Type::photos);
    const package::DirectoryEntry* meta = package.find(Type::meta);
    if (records.empty() || records.size() != photos.size() || records[0].key != key || !meta ||
        !package.head_valid(*meta))
        return {};
    PoseRefinement out;
    const std::string text(package.meta());
    out.decision = decision_in(text, Effect::pose_refinement);
    out.warnings = findings_in(text);
    // Packages written by earlier versions lack the leave-one-out poses.
    if (out.decision.on && !package.find(Type::pose_refinement_without)) return {};
    out.pairs = pairs_of(package);
    for (const auto& r :
         valid_records<package::LeaveOneOutPoseRecord>(package, Type::pose_refinement_without))
        out.without.push_back({r.without, r.photo, cam_from_origin(r)});
    for (std::size_t i = 0; i < records.size(); ++i) {
        out.photos.push_back({{}, records[i].motion_px, records[i].before, records[i].after});
        if (photos[i].flags & package::photo_registered) out.photos.back().pose = cam_from_origin(photos[i]);
    }
    return out;
}

std::vector<PairRecord> pairs_of(const PackageReader& package) {
    std::vector<PairRecord> out = valid_records<PairRecord>(package, Type::pairs);
    const auto photos = valid_records<PhotoRecord>(package, Type::photos).size();
    std::erase_if(out, [&](const PairRecord& p) { return p.a >= p.b || p.b >= photos; });
    return out;
}

std::vector<PairRecord> pairs_of(const EarlierPackages& earlier) {
    std::vector<PairRecord> out;
    for (const auto& package : earlier)
        if (package->finished()) {
            const auto pairs = pairs_of(package->reader());
            out.insert(out.end(), pairs.begin(), pairs.end());
        }
    return out;
}

std::optional<PoseRefinement> earlier_pose_refinement(const SceneKey& key, const SceneInput& scene,
                                                      std::span<const PhotoRecord> records,
                                                      std::span<const Pose> given, IdentityCache& identities,
                                                      const EarlierPackages& earlier) {
    if (std::ranges::none_of(earlier, [](const auto& package) { return package->finished(); })) return {};
    std::vector<PhotoState> states;
    for (std::size_t i = 0; i < scene.photos.size(); ++i) {
        const PhotoInput& photo = scene.photos[i];
        if (!std::filesystem::exists(photo.file)) return {};
        states.push_back(
            stage_keys(key, photo, given[i], identities.of(photo.file), mask_identity(photo, identities)));
        if (records[i].flags & package::photo_held_out) states.back().stages[std::size_t(Stage::tiles)] = {};
    }
    const EffectChoice choice = choice_of(key.settings.effects, Effect::pose_refinement);
    const std::uint64_t wanted = pose_refinement_key(
        pose_refinement_fingerprints(states, records, given, key.opengl), choice, key.settings.validate);
    for (const auto& package : earlier)
        if (package->finished())
            if (auto found = pose_refinement_of(package->reader(), wanted)) return found;
    return {};
}

void write_pose_refinement(PackageWriter& writer, const PoseRefinement& found, std::span<const Pose> given,
                           std::uint64_t key) {
    std::vector<PoseRefinementRecord> records;
    for (std::size_t i = 0; i < given.size(); ++i) {
        PoseRefinementRecord& r = records.emplace_back();
        set_pose(given[i], r);
        const PhotoPoseRefinement& p = found.photos[i];
        r.motion_px = p.motion_px;
        r.before = p.before;
        r.after = p.after;
        r.key = key;
    }
    std::vector<PairRecord> pairs(package::stored_pairs_per_photo * given.size(), PairRecord{});
    std::copy_n(found.pairs.begin(), std::min(pairs.size(), found.pairs.size()), pairs.begin());
    writer.write(Type::pose_refinement, package::scene_wide, bytes_of(records));
    writer.write(Type::pairs, package::scene_wide, bytes_of(pairs));
    std::vector<package::LeaveOneOutPoseRecord> without;
    for (const LeaveOneOutPose& p : found.without) {
        package::LeaveOneOutPoseRecord& r = without.emplace_back();
        r.without = p.without;
        r.photo = p.photo;
        set_pose(p.pose, r);
    }
    if (!without.empty()) writer.append(Type::pose_refinement_without, bytes_of(without));
}

}  // namespace vantage
