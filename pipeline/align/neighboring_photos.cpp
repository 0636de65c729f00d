#include "pipeline/align/neighboring_photos.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace vantage {
namespace {

const double least_cosine = std::cos(50 * std::numbers::pi / 180);

/// Cameras that are closer than this, relative to the median distance, share a viewpoint, as in bursts and
/// duplicate photos.
constexpr double same_place = 0.005;

/// The other photos in the photo's image set with a similar viewing direction, nearest first.
std::vector<std::uint32_t> neighbors(std::span<const PhotoInput> photos, std::uint32_t photo) {
    const Pose& own = photos[photo].camera.cam_from_world;
    std::vector<std::pair<double, std::uint32_t>> found;
    for (std::uint32_t i = 0; i < photos.size(); ++i) {
        const Pose& other = photos[i].camera.cam_from_world;
        if (i != photo && photos[i].image_set == photos[photo].image_set &&
            own.direction().dot(other.direction()) >= least_cosine)
            found.emplace_back((own.center() - other.center()).norm(), i);
    }
    std::ranges::sort(found);
    std::vector<std::uint32_t> out;
    const double least = found.empty() ? 0 : same_place * found[found.size() / 2].first;
    for (const auto& [distance, i] : found)
        if (distance > least) out.push_back(i);
    return out;
}

}  // namespace

std::vector<TwoPhotos> neighboring_photos(std::span<const PhotoInput> photos, std::size_t most,
                                          std::span<const std::size_t> ranks) {
    std::set<TwoPhotos> pairs;
    const std::size_t count = std::min(most, photos.size());
    for (std::size_t i = 0; i < count; ++i) {
        const auto photo = std::uint32_t(i * photos.size() / count);
        const std::vector<std::uint32_t> near = neighbors(photos, photo);
        for (const std::size_t rank : ranks)
            if (rank < near.size()) pairs.insert({std::min(photo, near[rank]), std::max(photo, near[rank])});
    }
    return {pairs.begin(), pairs.end()};
}

}  // namespace vantage
