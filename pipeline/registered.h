#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/geometry_stages.h"
#include "pipeline/prepare_plan.h"
#include "pipeline/refine/registration.h"
#include "scene/package_reader.h"
#include "scene/package_writer.h"

namespace vantage {

/// XXH3-64 of what each photo shows and from where: its tiles, camera and model, the pose as given, and what
/// renders.
std::vector<std::uint64_t> registration_fingerprints(std::span<const package::PhotoState> states,
                                                     std::span<const Pose> given, bool opengl);
/// Of all of them together.
std::uint64_t registration_key(std::span<const std::uint64_t> fingerprints, EffectChoice choice);

/// What an earlier package found under this key; nothing where it did not, or is not sound.
std::optional<Registration> registration_of(const PackageReader& package, std::uint64_t key);
/// The pairs that an earlier package measured; none where they are not sound.
std::vector<package::PairRecord> pairs_of(const PackageReader& package);
/// The poses that a package's scene came with.
std::vector<Pose> given_poses(const PackageReader& package);

/// Writes REGI and PAIR.
void write_registration(PackageWriter& writer, const Registration& found, std::span<const Pose> given,
                        std::uint64_t key);

/// Gives a photo another pose, and makes anew what depends on it, from what the package holds of the photo.
void move_photo(const GeometryStages& stages, const PackageReader& part, std::uint32_t photo,
                const Pose& pose, package::PhotoRecord& record, package::PhotoState& state);

}  // namespace vantage
