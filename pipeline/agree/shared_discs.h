#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/package_format.h"

namespace vantage {

/// A photo's discs of the surface, or none; of all photos.
using Samples = std::span<const std::span<const package::SampleRecord>>;

/// The photo shows the disc.
inline bool shown(const package::SampleRecord& s) { return s.linear[0] | s.linear[1] | s.linear[2]; }

/// The samples of all photos; of very many photos every `step`-th disc only, so that memory does not grow
/// with them.
struct PhotoSamples {
    std::vector<std::vector<package::SampleRecord>> of_photo;  ///< none where a photo has none
    std::size_t step = 1;
    std::vector<std::span<const package::SampleRecord>> spans() const {
        return {of_photo.begin(), of_photo.end()};
    }
};
/// From the bytes of SAMP, which `read` returns.
PhotoSamples read_samples(std::span<const package::PhotoRecord> photos,
                          const std::function<std::vector<std::byte>(std::uint32_t photo)>& read);

/// A disc in a photo: ln of its colour, and r^2 there.
struct Observation {
    std::uint32_t photo;
    float ln[3], radius2;
};

/// Discs that several photos show.
struct SharedDiscs {
    std::vector<Observation> all;
    std::vector<std::size_t> first;  ///< observation of each disc, and the end
    template <class Visit>
    void each_disc(const Visit& visit) const {
        for (std::size_t d = 0; d + 1 < first.size(); ++d)
            visit(std::span(all).subspan(first[d], first[d + 1] - first[d]), first[d]);
    }
};

/// Without photos that share fewer than 30 discs with others; `count`: how many each shares.
SharedDiscs shared_discs(Samples samples, std::vector<std::size_t>& count);

/// For each photo the first one that it is connected with by discs that both show.
std::vector<std::uint32_t> components(const SharedDiscs& discs, std::size_t photos);

}  // namespace vantage
