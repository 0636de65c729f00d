#include "player/plan/selection/shown_tiles.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/values/tiling.h"

namespace vantage {
namespace {

/// The number of visible texels of each tile of a pyramid, on levels [first, end).
class Shown {
  public:
    Shown(const package::PhotoRecord& photo, int first, int end) : first_(first) {
        for (int l = 0; l < end; ++l) {
            sizes_.push_back(level_size(int(photo.width), int(photo.height), l));
            texels_.emplace_back(std::size_t(l < first ? 0 : sizes_.back().tiles()), 0.0);
        }
    }
    int first() const { return first_; }
    int last() const { return int(sizes_.size()) - 1; }
    void add(const Eigen::Vector2d& pixel, int level, double texels) {
        const Level& size = sizes_[std::size_t(level)];
        const int x = std::min(int(pixel.x() / (1 << level)) / tile_content, size.columns() - 1),
                  y = std::min(int(pixel.y() / (1 << level)) / tile_content, size.rows() - 1);
        texels_[std::size_t(level)][std::size_t(y * size.columns() + x)] += texels;
    }
    /// Lists the tiles worth loading, by level; texels of other tiles are added to the next coarser level.
    void list(double worth, std::array<std::vector<std::uint32_t>, max_levels>& out) {
        constexpr double all = double(tile_content) * tile_content;
        for (int l = first_; l <= last(); ++l)
            for (std::uint32_t t = 0; t < texels_[std::size_t(l)].size(); ++t) {
                const double shown = texels_[std::size_t(l)][t];
                if (!(shown > 0)) continue;
                if (shown >= worth * all || l == last())
                    out[std::size_t(l)].push_back(t);
                else
                    promote(l, int(t), shown);
            }
    }

  private:
    void promote(int level, int tile, double shown) {
        const int columns = sizes_[std::size_t(level)].columns();
        const Level& coarser = sizes_[std::size_t(level) + 1];
        const int x = std::min(tile % columns / 2, coarser.columns() - 1),
                  y = std::min(tile / columns / 2, coarser.rows() - 1);
        texels_[std::size_t(level) + 1][std::size_t(y * coarser.columns() + x)] += shown / 4;
    }

    int first_;
    std::vector<Level> sizes_;
    std::vector<std::vector<double>> texels_;
};

/// Number of fine levels that a photo with this weight can omit. A level holds a few gray levels of detail:
/// at a weight of 1/32 the loss of one level is invisible, and at 1/128 the loss of two levels.
double spared_levels(double weight) { return std::clamp(-std::log2(8 * weight) / 2, 0.0, 2.0); }

}  // namespace

TileNeeds shown_tiles(const package::PhotoRecord& photo, const LensTable* lens, const Pose& pose,
                      const SampledSurface& surface, double worth, double coarse) {
    const Intrinsics k = intrinsics(photo);
    constexpr double slight = 0.25;  // a level with a smaller weight in the trilinear mix is not loaded
    Shown color(photo, 0, int(photo.levels)),
        weight_maps(photo, weight_map_level, weight_map_levels_end(int(photo.levels)));
    for (std::size_t i = 0; i < surface.samples.size(); ++i) {
        const SurfaceSample& s = surface.samples[i];
        if (!(surface.weights[i] > 0)) continue;
        const auto seen = project(k, pose, s.position);
        if (!seen || !in_frame(k, seen->pixel)) continue;
        const Eigen::Vector2d taken = lens ? photo_pixel(*lens, seen->pixel) : seen->pixel;
        if (!in_frame(k, taken)) continue;
        const double sampled = level_of_detail(s, k, pose), lod = sampled + spared_levels(surface.weights[i]);
        const auto add = [&](Shown& to, const Eigen::Vector2d& pixel, double level) {
            const int l = int(std::clamp(level, double(to.first()), double(to.last())));
            to.add(pixel, l, surface.pixels * std::exp2(2 * std::min(sampled - l, 1.0)));
            return l;
        };
        const int finest = add(color, taken, std::floor(lod + slight));
        if (std::ceil(lod - slight) > finest) add(color, taken, std::ceil(lod - slight));
        const int closest = add(weight_maps, seen->pixel, std::floor(lod));
        if (std::floor(coarse) > closest) add(weight_maps, seen->pixel, std::floor(coarse));
    }
    TileNeeds needs;
    color.list(worth, needs.color);
    weight_maps.list(2 * worth, needs.weight_maps);  // they come with depth: twice the bytes
    return needs;
}

}  // namespace vantage
