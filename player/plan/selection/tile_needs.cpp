#include "player/plan/selection/tile_needs.h"

#include <algorithm>
#include <cmath>

#include "base/values/tiling.h"

namespace vantage {
namespace {

/// A rectangle of photo pixels at full size.
using Rect = Eigen::AlignedBox2d;

/// Marks on the tiles of a photo's levels.
class Marks {
  public:
    explicit Marks(const package::PhotoRecord& photo) : levels_(int(photo.levels)) {
        for (int l = 0; l < std::max(levels_, weight_map_levels_end(levels_)); ++l) {
            sizes_.push_back(level_size(int(photo.width), int(photo.height), l));
            color_.emplace_back(std::size_t(sizes_.back().tiles()), false);
        }
        weight_maps_ = color_;
    }
    /// Marks the color tiles under `rect` and the weight map tiles under `rect_of_weight_maps` on all levels
    /// that trilinear sampling reads.
    void add(const Rect& rect, const Rect& rect_of_weight_maps, const LevelRange& range) {
        // A level whose weight in the trilinear mix is smaller than this is not loaded.
        constexpr double slight = 0.25;
        const int finest = int(std::clamp(range.finest + slight, 0.0, levels_ - 1.0));
        const int coarsest =
            int(std::clamp(std::ceil(range.coarsest - slight), double(finest), levels_ - 1.0));
        for (int l = finest; l <= coarsest; ++l) mark(color_, rect, l);
        const int end = weight_map_levels_end(levels_) - 1;
        for (int l = std::clamp(finest, weight_map_level, end);
             l <= std::clamp(coarsest, weight_map_level, end); ++l)
            mark(weight_maps_, rect_of_weight_maps, l);
    }
    TileNeeds needs() const {
        TileNeeds out;
        for (std::size_t l = 0; l < color_.size(); ++l) {
            if (int(l) < levels_) out.color[l] = listed(color_[l]);
            out.weight_maps[l] = listed(weight_maps_[l]);
        }
        return out;
    }

  private:
    void mark(std::vector<std::vector<bool>>& tiles, const Rect& rect, int level) const {
        const Level& size = sizes_[std::size_t(level)];
        const double s = 1.0 / (1 << level);
        const auto tile = [](double texel, int count) {
            return int(std::clamp(std::floor(texel / tile_content), 0.0, double(count - 1)));
        };
        const int x0 = tile(rect.min().x() * s, size.columns()),
                  x1 = tile(rect.max().x() * s, size.columns());
        const int y0 = tile(rect.min().y() * s, size.rows()), y1 = tile(rect.max().y() * s, size.rows());
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                tiles[std::size_t(level)][std::size_t(y) * std::size_t(size.columns()) + std::size_t(x)] =
                    true;
    }
    static std::vector<std::uint32_t> listed(const std::vector<bool>& marks) {
        std::vector<std::uint32_t> out;
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (marks[i]) out.push_back(std::uint32_t(i));
        return out;
    }

    int levels_;
    std::vector<Level> sizes_;
    std::vector<std::vector<bool>> color_, weight_maps_;
};

}  // namespace

std::size_t TileNeeds::tiles() const {
    std::size_t n = 0;
    for (std::size_t l = 0; l < max_levels; ++l) n += color[l].size() + weight_maps[l].size();
    return n;
}

TileNeeds tile_needs(const package::PhotoRecord& photo, const LensTable* lens,
                     std::span<const package::CoverageRecord> coverage,
                     std::span<const ClusterLevels> clusters) {
    Marks marks(photo);
    const double w = photo.width / 65535.0, h = photo.height / 65535.0;
    for (const ClusterLevels& c : clusters) {
        const package::CoverageRecord& r = coverage[c.cluster];
        if (!r.seen) continue;
        const Rect rect(Eigen::Vector2d(r.u0 * w, r.v0 * h), Eigen::Vector2d(r.u1 * w, r.v1 * h));
        marks.add(lens ? photo_bounds(*lens, rect) : rect, rect, c.levels);
    }
    return marks.needs();
}

TileNeeds whole_photo_needs(const package::PhotoRecord& photo, double density) {
    const double lod = std::max(0.0, -std::log2(std::max(density, 1e-9)));
    Marks marks(photo);
    const Rect all(Eigen::Vector2d(0, 0), Eigen::Vector2d(photo.width, photo.height));
    marks.add(all, all, {lod, lod});
    TileNeeds needs = marks.needs();
    for (auto& level : needs.weight_maps) level.clear();
    return needs;
}

}  // namespace vantage
