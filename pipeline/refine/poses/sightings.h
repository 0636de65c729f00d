#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/refine/coarse_photo.h"

namespace vantage {

/// The surface at a pixel as seen in another photo.
struct Sighting {
    std::uint32_t photo;  ///< index in the scene
    float root[3];        ///< square roots of linear light, as exposed
    float smooth[3];      ///< square roots of CoarsePhoto's `smooth`
    float theta;          ///< radians, between the rays from the surface to the viewer and to the photo
    float weight;         ///< blending weight of the lumigraph, without transient masking
    float x, y;           ///< position in the other photo, texels
    float radius2;        ///< squared vignetting_radius at that position
};

/// The sightings of every pixel of a view, pixel by pixel.
struct Sightings {
    std::vector<Sighting> all;
    std::vector<std::uint32_t> first;  ///< index in `all` of each pixel's first sighting, followed by the end
    std::span<const Sighting> at(std::size_t pixel) const {
        return std::span(all).subspan(first[pixel], first[pixel + 1] - first[pixel]);
    }
};

/// A photo from which a view may be rendered.
struct OtherPhoto {
    std::uint32_t index;
    const CoarsePhoto* photo;
    Pose pose;  ///< pose for its projection; its depth was rendered from the pose in `photo`
};

/// Projects the surface visible in `target` into the others, as shaders/blend.frag does with coordinates per
/// fragment, with the same visibility test and weights. Of the target, only its camera and depth are read.
Sightings sightings(const CoarsePhoto& target, std::span<const OtherPhoto> others);
/// The same with a pose of the target other than that from which its depth was rendered.
Sightings sightings(const CoarsePhoto& target, const Pose& pose, std::span<const OtherPhoto> others);

}  // namespace vantage
