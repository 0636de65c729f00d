#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/refine/coarse_photo.h"

namespace vantage {

/// How another photo sees the surface at a pixel.
struct Sighting {
    std::uint32_t photo;  ///< index of the photo in the scene
    float root[3];        ///< square roots of linear light, as exposed
    float smooth[3];      ///< square roots of CoarsePhoto's `smooth`
    float theta;    ///< angle in radians between the rays from the surface to the viewer and to the photo
    float weight;   ///< the lumigraph's blending weight, without transient masking
    float x, y;     ///< position in the other photo, texels
    float radius2;  ///< squared vignetting_radius at that position
};

/// The sightings for every pixel of a view, pixel by pixel.
struct Sightings {
    std::vector<Sighting> all;
    std::vector<std::uint32_t> first;  ///< index into `all` of each pixel's first sighting, and the end
    std::span<const Sighting> at(std::size_t pixel) const {
        return std::span(all).subspan(first[pixel], first[pixel + 1] - first[pixel]);
    }
};

/// A photo from which a view may be rendered.
struct OtherPhoto {
    std::uint32_t index;
    const CoarsePhoto* photo;
    Pose pose;  ///< pose for the projection; the depth was rendered from the pose in `photo`
};

/// Projects the surface that is visible in `target` into the other photos, as shaders/blend.frag does with
/// coordinates per fragment, using the same visibility test and weights. Only the target's camera and depth
/// are read.
Sightings sightings(const CoarsePhoto& target, std::span<const OtherPhoto> others);
/// Projects the surface with a pose of the target that differs from the pose from which the target's depth
/// was rendered.
Sightings sightings(const CoarsePhoto& target, const Pose& pose, std::span<const OtherPhoto> others);

}  // namespace vantage
