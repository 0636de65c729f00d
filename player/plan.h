#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/cluster_tree.h"
#include "player/tile_needs.h"
#include "player/view.h"
#include "scene/package_reader.h"

namespace vantage {

/// What plans are made of: the package's photos and clusters, and what each photo sees. Spans live as long as
/// the package.
struct PlanScene {
    std::span<const package::PhotoRecord> photos;
    std::span<const package::ClusterRecord> clusters;
    ClusterTree tree;
    std::vector<Intrinsics> intrinsics;                              ///< a photo
    std::vector<Pose> poses;                                         ///< a photo, cam_from_origin
    std::vector<std::span<const package::CoverageRecord>> coverage;  ///< a photo; empty where held out
    std::vector<std::span<const std::uint64_t>> visible;             ///< a photo, as VISB
    std::size_t triangles = 0;
    std::span<const Eigen::Vector3f> positions;
    std::span<const std::uint32_t> indices;
};
/// Throws Error(damaged).
PlanScene make_plan_scene(const PackageReader& package);

/// How photos are chosen.
enum class Choice {
    cover,      ///< a weighted set cover: every surface in view that some photo sees gets one, best first
    nearest,    ///< those whose cameras are nearest to the viewer
    direction,  ///< [P]: best corrected directions and largest hulls, and for what stays uncovered, normals
};

struct PlanSettings {
    Choice choice = Choice::cover;
    int photos = 0;          ///< at least so many, where so many see the view; 0: all
    double sharpness = 0;    ///< radians of the angle weight; 0: weights do not fall with the angle
    double angle_limit = 0;  ///< radians between the viewing directions beyond which a photo is used only
                             ///< where it alone sees a surface; 0: none
    double samples = 1;      ///< along a pixel's side
    double worth = 0;        ///< share of a tile's texels that must be shown, to need it; 0: all that may be
    bool operator==(const PlanSettings&) const = default;
};

struct PlannedPhoto {
    std::uint32_t photo;
    double agreement;                     ///< with the view: share of it seen, by angle, in [0, 1]
    std::vector<std::uint32_t> clusters;  ///< drawn with this photo, ascending
    std::vector<float> weights;           ///< of each, beside the best photo's, at most 1
    TileNeeds needs;                      ///< of clusters seen, see make_plan
    TileNeeds later;                      ///< of clusters in view that were not seen
};

/// What a view is drawn from; photos by falling agreement.
struct Plan {
    std::vector<std::uint32_t> clusters;
    std::vector<PlannedPhoto> photos;
    double uncovered = 0;  ///< share of what some allowed photo sees in view that none of the chosen does
};

/// Chooses among the photos `allowed`; those in `previous` are preferred a little, so that the choice does
/// not flicker. `seen` are triangles that samples of the view (or one just before) showed, numbers from 1:
/// with them the plan covers what is seen, without them all that is in view. Depends on its arguments alone.
Plan make_plan(const PlanScene& scene, const View& view, const PlanSettings& settings,
               std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous = {},
               std::span<const std::uint32_t> seen = {});

/// Agreement of every photo with a view, 0 for one that sees nothing of it.
std::vector<double> agreements(const PlanScene& scene, const View& view);

}  // namespace vantage
