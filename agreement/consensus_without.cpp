#include "agreement/consensus_without.h"

#include "scene/error.h"

namespace vantage {
namespace {

constexpr std::size_t cached_views = 24;  ///< some 7 MB each

ConsensusPartners partners_in(const PackageReader& package, const PhotoSamples& samples) {
    const auto discs =
        thinned(surface_disc_set(package.records<Eigen::Vector3f>(package::Type::positions),
                                 package.records<std::uint32_t>(package::Type::indices),
                                 package.scene().reference_density, bounds_from_origin(package.scene())),
                samples.step);
    const auto spans = samples.spans();
    return ConsensusPartners(SharedSurface(package.photos(), spans, discs));
}

/// The photo's view, read from chunks whose checksums match.
ConsensusView sound_view(const PackageReader& package, std::uint32_t photo) {
    const package::PhotoRecord& r = package.photos()[photo];
    const int level = consensus_level(r);
    for (const auto& [type, l] : {std::pair{package::Type::tiles, std::min(level, int(r.levels) - 1)},
                                  std::pair{package::Type::depth, level}})
        if (const auto* e = package.find(type, photo, std::uint32_t(l)); e && !package.sound(*e))
            throw Error(Exit::damaged,
                        package.path().string() + ": " + describe(*e, package) + ": checksum does not match");
    return read_consensus_view(package, r, photo, level);
}

}  // namespace

ConsensusWithout::ConsensusWithout(const PackageReader& package, const PhotoSamples& samples)
    : partners_(partners_in(package, samples)),
      uncorrected_(cached_views, [&package](std::uint32_t i) { return sound_view(package, i); }) {}

void ConsensusWithout::leave_out(std::uint32_t photo, PhotoColors colors,
                                 std::span<const package::PhotoRecord> photos) {
    without_ = photo;
    colors_ = std::move(colors);
    poses_.clear();
    for (const package::PhotoRecord& p : photos) poses_.push_back(cam_from_origin(p));
    maps_.clear();
}

ConsensusView ConsensusWithout::view(std::uint32_t photo) const {
    ConsensusView out = corrected(*uncorrected_.get(photo), colors_.ln_gain[photo], colors_.falloff[photo]);
    out.pose = poses_[photo];
    return out;
}

const ConsensusMap* ConsensusWithout::of(std::uint32_t photo) {
    if (const auto known = maps_.find(photo); known != maps_.end()) return &known->second;
    const std::vector<std::uint32_t> partners = partners_.of(photo, without_);
    if (partners.size() < 2) return nullptr;
    std::vector<ConsensusView> views;
    for (const std::uint32_t i : partners) views.push_back(view(i));
    std::vector<const ConsensusView*> others;
    for (const ConsensusView& v : views) others.push_back(&v);
    return &maps_.emplace(photo, consensus_of(view(photo), others)).first->second;
}

}  // namespace vantage
