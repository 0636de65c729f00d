#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "player/plan/plan.h"
#include "player/render/weights.h"

namespace vantage {

/// Weighted average [M], unstructured lumigraph (after Buehler et al. 2001) or best photo [P].
enum class Blend { average, lumigraph, best };
enum class Coordinates { automatic, vertex, fragment };  ///< automatic: as the package's effects say
enum class Show { colors, sources, coverage };           ///< false colours: which photo, how many photos
enum class Compare { nothing, side_by_side, wiper, difference };

inline constexpr int most_photos_per_pass = 16;
/// Photos that a window blends: 4 are as good as 8 and take two thirds to four fifths of the time
/// (vantage-bench, "blending").
inline constexpr int window_photos = 4;

/// How a view is rendered.
struct RenderSettings {
    Blend blend = Blend::lumigraph;
    bool consensus = false;  ///< what disagrees with the weighted mean counts less (a second round of passes)
    Coordinates coordinates = Coordinates::automatic;
    WeightSettings weights;
    Choice choice = Choice::cover;
    int photos = 0;            ///< at least so many; 0: all
    double angle_limit = 150;  ///< degrees between viewing directions [M]
    bool fill_holes = false;   ///< plain shading where no photo contributes, background beside the model
    int photos_per_pass = 8;   ///< 1 to 16
    double lod_bias = 0;       ///< levels; below 0 is sharper
    bool trilinear = true;     ///< between two levels; else the nearest level
    int anisotropy = 1;        ///< taps along a sample's longer side in the photo, 1 to 16
    bool half_sums = false;    ///< sums of a pass in half precision: half the bandwidth
    bool thumbnails = false;   ///< nothing finer is asked for
    Show show = Show::colors;
    Compare compare = Compare::nothing;
    std::uint32_t compare_photo = 0;
    std::optional<View> weights_from;       ///< weights as from there, frozen [M]
    double wiper = 0.5;                     ///< share of the width
    bool refined_colors = true;             ///< gains and falloff where the package's effects are on
    std::optional<std::uint32_t> exposure;  ///< of this photo, instead of the view's
    bool complete = true;                   ///< wait for all that the view needs, or show what is there
    bool whole_photos = false;              ///< upload a photo whole, at once (to compare with)
    std::size_t upload_bytes = std::numeric_limits<std::size_t>::max();  ///< a frame
    float background[3] = {0.012f, 0.014f, 0.018f};                      ///< linear
};

/// What a rendered frame was made of.
struct FrameReport {
    std::size_t clusters = 0, photos = 0, passes = 0, draws = 0;
    std::size_t tiles = 0;          ///< needed
    std::size_t tiles_missing = 0;  ///< of them not resident: coarser ones were shown
    std::size_t tiles_damaged = 0;  ///< seen since opening
    std::size_t uploaded = 0;       ///< bytes
    double uncovered = 0;           ///< share of what photos see in view that the chosen ones do not
    bool settled = false;           ///< everything is there and has faded in
};

/// Memory that the player keeps to, bytes.
struct MemoryBudget {
    std::uint64_t graphics = 0;                    ///< 0: by the size of the frames
    std::uint64_t ring = std::uint64_t(32) << 20;  ///< through which uploads go
};

}  // namespace vantage
