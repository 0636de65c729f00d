#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// Views of the samples of all photos. Each photo has one record per disc, or none if it has no pixels.
using Samples = std::span<const std::span<const package::SampleRecord>>;

/// Whether the photo shows the disc.
inline bool shown(const package::SampleRecord& s) { return s.linear[0] | s.linear[1] | s.linear[2]; }

/// The samples of all photos. With many photos, only every `step`-th disc is kept, to limit memory use.
struct PhotoSamples {
    std::vector<std::vector<package::SampleRecord>> of_photo;  ///< empty for photos without pixels
    std::size_t step = 1;
    std::vector<std::span<const package::SampleRecord>> spans() const;
};
/// Keeps every `step`-th disc.
PhotoSamples thinned(Samples samples, std::size_t step);
/// Keeps enough discs to fit the color corrections without a held-out photo, since a gain is only one number
/// per photo and channel.
PhotoSamples samples_to_fit(Samples samples);
/// `read` returns the bytes of a photo's SAMP chunk.
PhotoSamples read_samples(std::span<const package::PhotoRecord> photos,
                          const std::function<std::vector<std::byte>(std::uint32_t photo)>& read);

/// A disc as seen in a photo: ln of its linear color, and r^2 for the lens's vignetting (see
/// vignetting_radius).
struct Observation {
    std::uint32_t photo;
    float ln[3], radius2;
};

/// Discs visible in several photos.
struct SharedDiscs {
    std::vector<Observation> all;    ///< disc by disc
    std::vector<std::size_t> first;  ///< where each disc starts in `all`, and where the last one ends

    /// Calls visit(observations of a disc, index of the first of them) for each disc.
    template <class Visit>
    void each_disc(const Visit& visit) const {
        for (std::size_t d = 0; d + 1 < first.size(); ++d)
            visit(std::span(all).subspan(first[d], first[d + 1] - first[d]), first[d]);
    }
};

/// The discs that photos share, without photos that share fewer than 30 discs with others. Sets `count` to
/// the number of shared discs of each photo.
SharedDiscs shared_discs(Samples samples, std::vector<std::size_t>& count);

/// The components of photos connected by shared discs: for each photo, the first photo of its component.
std::vector<std::uint32_t> components(const SharedDiscs& discs, std::size_t photos);

}  // namespace vantage
