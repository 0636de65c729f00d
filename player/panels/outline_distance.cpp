#include "player/panels/outline_distance.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vantage {
namespace {

using Eigen::Vector2f;

/// A straight piece of an outline in a texel.
struct Piece {
    Vector2f middle;  ///< texels; the center of texel (0, 0) is at (0, 0)
    Vector2f half;    ///< vector from the center to an end
    bool inside;      ///< whether the texel's center is inside
};

/// A picture and its outlines.
struct Outlines {
    std::span<const std::uint8_t> coverage;
    int width, height;
    std::vector<std::int32_t> piece_at{};  ///< for each texel, the index of its piece; -1: none
    std::vector<Piece> pieces{};

    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    /// The fraction of a texel that is inside; 0 outside the picture.
    float share(int x, int y) const { return has(x, y) ? float(coverage[index(x, y)]) / 255.0f : 0.0f; }
};

/// Unit direction in which coverage increases; zero in a texel without such a direction.
Vector2f inward(const Outlines& o, int x, int y) {
    constexpr float corner = 1, side = 1.41421356f;
    Vector2f sum = Vector2f::Zero();
    for (const int s : {-1, 1}) {
        const auto sign = float(s);
        sum.x() +=
            sign * (corner * (o.share(x + s, y - 1) + o.share(x + s, y + 1)) + side * o.share(x + s, y));
        sum.y() +=
            sign * (corner * (o.share(x - 1, y + s) + o.share(x + 1, y + s)) + side * o.share(x, y + s));
    }
    const float length = sum.norm();
    return length > 1e-4f ? Vector2f(sum / length) : Vector2f::Zero();
}

/// Distance of a straight edge from the texel's center, positive inward, that leaves `share` of the texel
/// inside (Gustavson and Strand 2011).
float edge_offset(const Vector2f& inward, float share) {
    const float large = std::max(std::abs(inward.x()), std::abs(inward.y())),
                small = std::min(std::abs(inward.x()), std::abs(inward.y()));
    const float corner = large > 0 ? small / (2 * large) : 0;  // maximum share of a triangle at a corner
    if (share < corner) return (large + small) / 2 - std::sqrt(2 * large * small * share);
    if (share > 1 - corner) return -(large + small) / 2 + std::sqrt(2 * large * small * (1 - share));
    return (0.5f - share) * large;
}

/// The part of an edge that lies within the texel. The edge is perpendicular to `inward`, `offset` from the
/// texel's center.
Piece piece_of(const Vector2f& texel, const Vector2f& inward, float offset) {
    const Vector2f off = inward * offset, along(-inward.y(), inward.x());
    float low = -std::numeric_limits<float>::infinity(), high = -low;
    for (int i = 0; i < 2; ++i) {
        if (std::abs(along[i]) < 1e-6f) continue;
        const float a = (-0.5f - off[i]) / along[i], b = (0.5f - off[i]) / along[i];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    if (!(high > low)) low = high = 0;
    return {texel + off + along * ((low + high) / 2), along * ((high - low) / 2), offset < 0};
}

bool at_edge(const Outlines& o, int x, int y) {
    const float share = o.share(x, y);
    if (share > 0 && share < 1) return true;
    if (share == 0) return false;
    // An edge between two texels belongs to the texel that is inside.
    return o.share(x - 1, y) == 0 || o.share(x + 1, y) == 0 || o.share(x, y - 1) == 0 ||
           o.share(x, y + 1) == 0;
}

void find_pieces(Outlines& o) {
    o.piece_at.assign(o.coverage.size(), -1);
    for (int y = 0; y < o.height; ++y)
        for (int x = 0; x < o.width; ++x) {
            if (!at_edge(o, x, y)) continue;
            const Vector2f direction = inward(o, x, y);
            if (direction.isZero()) continue;
            o.piece_at[o.index(x, y)] = std::int32_t(o.pieces.size());
            o.pieces.push_back(
                piece_of(Vector2f(float(x), float(y)), direction, edge_offset(direction, o.share(x, y))));
        }
}

constexpr std::int32_t nowhere = -1;

/// For each texel, the row of the nearest texel in its column that contains a piece.
std::vector<std::int32_t> nearest_rows(const Outlines& o) {
    std::vector<std::int32_t> rows(o.coverage.size(), nowhere);
    for (int x = 0; x < o.width; ++x) {
        std::int32_t above = nowhere, below = nowhere;
        for (int y = 0; y < o.height; ++y) {
            if (o.piece_at[o.index(x, y)] >= 0) above = y;
            rows[o.index(x, y)] = above;
        }
        for (int y = o.height - 1; y >= 0; --y) {
            if (o.piece_at[o.index(x, y)] >= 0) below = y;
            std::int32_t& row = rows[o.index(x, y)];
            if (below != nowhere && (row == nowhere || below - y < y - row)) row = below;
        }
    }
    return rows;
}

/// The lower envelope of a row's parabolas: their columns, from left to right, and the start of each.
struct Envelope {
    std::vector<int> columns;
    std::vector<double> from;
};

/// Computes the envelope from each column's squared distance to the row given by nearest_rows().
void find_envelope(const Outlines& o, const std::vector<std::int32_t>& rows, int y, Envelope& e) {
    constexpr double everywhere = -std::numeric_limits<double>::infinity();
    const auto height = [&](int x) { return std::pow(double(rows[o.index(x, y)] - y), 2) + double(x) * x; };
    e.columns.clear(), e.from.clear();
    for (int x = 0; x < o.width; ++x) {
        if (rows[o.index(x, y)] == nowhere) continue;
        double begin = everywhere;
        while (!e.columns.empty()) {
            const int last = e.columns.back();
            begin = (height(x) - height(last)) / (2.0 * (x - last));
            if (begin > e.from.back()) break;
            e.columns.pop_back(), e.from.pop_back();
            begin = everywhere;
        }
        e.columns.push_back(x), e.from.push_back(begin);
    }
}

/// For each texel, the nearest texel that contains a piece; exact, in linear time (Felzenszwalb and
/// Huttenlocher 2012).
std::vector<std::int32_t> nearest_texels(const Outlines& o) {
    const std::vector<std::int32_t> rows = nearest_rows(o);
    std::vector<std::int32_t> nearest(o.coverage.size(), nowhere);
    Envelope e;
    for (int y = 0; y < o.height; ++y) {
        find_envelope(o, rows, y, e);
        if (e.columns.empty()) continue;
        std::size_t k = 0;
        for (int x = 0; x < o.width; ++x) {
            while (k + 1 < e.columns.size() && e.from[k + 1] <= double(x)) ++k;
            const int column = e.columns[k];
            nearest[o.index(x, y)] = std::int32_t(o.index(column, rows[o.index(column, y)]));
        }
    }
    return nearest;
}

float distance_to(const Piece& piece, const Vector2f& point) {
    const Vector2f off = point - piece.middle;
    const float square = piece.half.squaredNorm();
    const float share = square > 0 ? std::clamp(off.dot(piece.half) / square, -1.0f, 1.0f) : 0;
    return (off - share * piece.half).norm();
}

/// Distance to the nearest piece, at most `most`. Considers the pieces in `nearest` of the texel and of its
/// neighbors, and the pieces in the neighbors of the texel's own `nearest`.
float distance_at(const Outlines& o, const std::vector<std::int32_t>& nearest, int x, int y, float most) {
    const Vector2f point{float(x), float(y)};
    float least = most;
    const auto consider = [&](int px, int py) {
        if (!o.has(px, py)) return;
        if (const std::int32_t p = o.piece_at[o.index(px, py)]; p >= 0)
            least = std::min(least, distance_to(o.pieces[std::size_t(p)], point));
    };
    const auto place = [&](std::int32_t texel) { return std::pair(texel % o.width, texel / o.width); };
    const auto [own_x, own_y] = place(nearest[o.index(x, y)]);
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            consider(own_x + dx, own_y + dy);
            if (!o.has(x + dx, y + dy)) continue;
            const auto [near_x, near_y] = place(nearest[o.index(x + dx, y + dy)]);
            consider(near_x, near_y);
        }
    return least;
}

}  // namespace

std::vector<float> outline_distances(std::span<const std::uint8_t> coverage, int width, int height,
                                     float most) {
    Outlines o{coverage, width, height};
    find_pieces(o);
    std::vector<float> distances(coverage.size());
    const std::vector<std::int32_t> nearest = nearest_texels(o);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = o.index(x, y);
            const std::int32_t piece = o.piece_at[i], site = nearest[i];
            const bool inside = piece >= 0 ? o.pieces[std::size_t(piece)].inside : coverage[i] >= 128;
            const float reach = most + 2;
            const bool close =
                site != nowhere && std::hypot(float(site % width - x), float(site / width - y)) < reach;
            const float distance = close ? distance_at(o, nearest, x, y, most) : most;
            distances[i] = inside ? distance : -distance;
        }
    return distances;
}

}  // namespace vantage
