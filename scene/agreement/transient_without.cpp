#include "scene/agreement/transient_without.h"

#include "scene/package/contents/opaque_part.h"

namespace vantage {
namespace {

constexpr std::size_t cached_views =
    16;  ///< about 7 MB each; two versions are cached, uncorrected and corrected

TransientPartners partners_in(const PackageReader& package, const PhotoSamples& samples) {
    const auto opaque = 3 * std::size_t(opaque_part(package).triangles);
    const auto discs =
        thinned(surface_disc_set(package.records<Eigen::Vector3f>(package::Type::positions),
                                 package.records<std::uint32_t>(package::Type::indices).first(opaque),
                                 package.scene().reference_density, bounds_from_origin(package.scene())),
                samples.step);
    const auto spans = samples.spans();
    return TransientPartners(SharedSurface(package.photos(), spans, discs));
}

}  // namespace

TransientWithout::TransientWithout(const PackageReader& package, const PhotoSamples& samples)
    : partners_(partners_in(package, samples)), uncorrected_(cached_views, [&package](std::uint32_t i) {
          const package::PhotoRecord& r = package.photos()[i];
          return read_transient_view(package, r, i, transient_level(r));
      }) {}

void TransientWithout::hold_out(std::uint32_t photo, PhotoColors colors,
                                std::span<const package::PhotoRecord> photos) {
    without_ = photo;
    colors_ = std::move(colors);
    poses_.clear();
    for (const package::PhotoRecord& p : photos) poses_.push_back(cam_from_origin(p));
    maps_.clear();
    corrected_.emplace(cached_views, [this](std::uint32_t i) {
        TransientView view = corrected(*uncorrected_.get(i), colors_.ln_gain[i], colors_.vignetting[i]);
        view.pose = poses_[i];
        return view;
    });
}

const TransientMap* TransientWithout::of(std::uint32_t photo) {
    auto at = maps_.find(photo);
    if (at == maps_.end())
        at = maps_.emplace(photo, transient_of(photo, partners_.of(photo, without_), *corrected_)).first;
    return at->second.weight.empty() ? nullptr : &at->second;
}

}  // namespace vantage
