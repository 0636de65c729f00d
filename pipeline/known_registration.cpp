#include "pipeline/known_registration.h"

#include <algorithm>

#include "pipeline/identity_cache.h"
#include "pipeline/registered.h"

namespace vantage {

std::vector<Pose> given_poses(const SceneInput& scene, const Eigen::Vector3d& origin) {
    std::vector<Pose> out;
    for (const PhotoInput& p : scene.photos) out.push_back(p.camera.cam_from_world.relative_to(origin));
    return out;
}

std::optional<Registration> known_registration(const SceneKey& key, const SceneInput& scene,
                                               std::span<const package::PhotoRecord> records,
                                               std::span<const Pose> given, IdentityCache& identities,
                                               const std::vector<std::unique_ptr<Former>>& formers) {
    if (std::ranges::none_of(formers, [](const auto& f) { return f->finished(); })) return {};
    std::vector<package::PhotoState> states;
    for (std::size_t i = 0; i < scene.photos.size(); ++i) {
        const PhotoInput& photo = scene.photos[i];
        if (!std::filesystem::exists(photo.file)) return {};
        states.push_back(
            stage_keys(key, photo, given[i], identities.of(photo.file), stencil_identity(photo, identities)));
        if (records[i].flags & package::photo_held_out)
            states.back().stages[std::size_t(package::Stage::tiles)] = {};
    }
    const EffectChoice choice = choice_of(key.settings.effects, Effect::registration);
    const std::uint64_t wanted =
        registration_key(registration_fingerprints(states, given, key.opengl), choice);
    for (const auto& former : formers)
        if (former->finished())
            if (auto found = registration_of(former->reader(), wanted)) return found;
    return {};
}

std::vector<package::PairRecord> pairs_of_formers(const std::vector<std::unique_ptr<Former>>& formers) {
    std::vector<package::PairRecord> out;
    for (const auto& former : formers)
        if (former->finished()) {
            const auto pairs = pairs_of(former->reader());
            out.insert(out.end(), pairs.begin(), pairs.end());
        }
    return out;
}

}  // namespace vantage
