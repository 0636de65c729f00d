#include "pipeline/mesh/subdivide.h"

#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace vantage {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
constexpr std::size_t max_added_triangles = std::size_t(1) << 18;
constexpr std::uint32_t no_midpoint = ~0u;

std::uint32_t add_midpoint(Mesh& m, std::uint32_t a, std::uint32_t b) {
    m.positions.push_back((m.positions[a] + m.positions[b]) / 2);
    if (!m.normals.empty()) {
        const Eigen::Vector3f sum = m.normals[a] + m.normals[b];
        m.normals.push_back(sum.norm() > 1e-6f ? Eigen::Vector3f(sum.normalized()) : m.normals[a]);
    }
    if (!m.colors.empty()) {
        std::array<std::uint8_t, 4> c{};
        for (std::size_t i = 0; i < 4; ++i) c[i] = std::uint8_t((m.colors[a][i] + m.colors[b][i] + 1) / 2);
        m.colors.push_back(c);
    }
    for (VertexField& field : m.scalars) field.values.push_back((field.values[a] + field.values[b]) / 2);
    return std::uint32_t(m.positions.size() - 1);
}

/// The edges to halve: those longer than `longest` between vertices that are not strays.
struct Limit {
    double longest;
    std::span<const std::uint32_t> strays;  ///< ascending

    bool is_exceeded(const Mesh& m, std::uint32_t a, std::uint32_t b) const {
        const auto stray = [&](std::uint32_t v) { return std::ranges::binary_search(strays, v); };
        return (m.positions[a] - m.positions[b]).squaredNorm() > longest * longest && !stray(a) && !stray(b);
    }
    bool is_exceeded(const Mesh& m, const Triangle& t) const {
        return is_exceeded(m, t[0], t[1]) || is_exceeded(m, t[1], t[2]) || is_exceeded(m, t[2], t[0]);
    }
};

/// Midpoints of long edges, shared by the triangles on both sides.
class Midpoints {
  public:
    Midpoints(Mesh& mesh, const Limit& limit) : mesh_(mesh), limit_(limit) {}
    /// The midpoint vertex of an edge if the edge exceeds the limit, otherwise `no_midpoint`.
    std::uint32_t of(std::uint32_t a, std::uint32_t b) {
        if (!limit_.is_exceeded(mesh_, a, b)) return no_midpoint;
        const auto [low, high] = std::minmax(a, b);
        const auto [at, inserted] = vertices_.try_emplace(std::uint64_t(low) << 32 | high, no_midpoint);
        if (inserted) at->second = add_midpoint(mesh_, low, high);
        return at->second;
    }

  private:
    Mesh& mesh_;
    Limit limit_;
    std::unordered_map<std::uint64_t, std::uint32_t> vertices_;  ///< by edge
};

/// Appends the pieces of a triangle; m[i] is the midpoint of its edge from corner i to the next, if that edge
/// is halved.
void add_pieces(const Triangle& t, const Triangle& m, std::vector<Triangle>& out) {
    const auto halved = std::ranges::count_if(m, [](auto v) { return v != no_midpoint; });
    if (halved == 0) return out.push_back(t);
    // Rotate the corners so that edge 0 is halved and, if exactly two edges are halved, edge 2 is not.
    std::size_t turn = 0;
    while (m[turn] == no_midpoint || (halved == 2 && m[(turn + 2) % 3] != no_midpoint)) ++turn;
    const std::uint32_t a = t[turn], b = t[(turn + 1) % 3], c = t[(turn + 2) % 3];
    const std::uint32_t ab = m[turn], bc = m[(turn + 1) % 3], ca = m[(turn + 2) % 3];
    if (halved == 1) {
        out.insert(out.end(), {{a, ab, c}, {ab, b, c}});
    } else if (halved == 2) {
        out.insert(out.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
    } else {
        out.insert(out.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
}

/// The mesh subdivided until no edge exceeds the limit; empty if that takes too many triangles.
std::optional<Mesh> subdivided(const Mesh& mesh, const Limit& limit) {
    Mesh out = mesh;
    const auto large = std::stable_partition(out.triangles.begin(), out.triangles.end(),
                                             [&](const Triangle& t) { return !limit.is_exceeded(out, t); });
    std::vector<Triangle> todo(large, out.triangles.end());
    out.triangles.erase(large, out.triangles.end());
    Midpoints midpoints(out, limit);
    while (!todo.empty()) {
        std::vector<Triangle> pieces;
        for (const Triangle& t : todo)
            add_pieces(t, {midpoints.of(t[0], t[1]), midpoints.of(t[1], t[2]), midpoints.of(t[2], t[0])},
                       pieces);
        todo.clear();
        for (const Triangle& t : pieces) (limit.is_exceeded(out, t) ? todo : out.triangles).push_back(t);
        if (out.triangles.size() + todo.size() > mesh.triangles.size() + max_added_triangles)
            return std::nullopt;
    }
    return out;
}

}  // namespace

std::size_t subdivide_large_triangles(Mesh& mesh, const MainBox& box) {
    const std::size_t before = mesh.triangles.size();
    const double extent = box.diagonal();
    for (double longest = extent / 64; longest > 0 && longest < extent; longest *= 2) {
        const Limit limit{longest, box.strays};
        const auto large = [&](const Triangle& t) { return limit.is_exceeded(mesh, t); };
        if (std::ranges::none_of(mesh.triangles, large)) break;
        auto fine = subdivided(mesh, limit);
        if (!fine) continue;
        mesh = std::move(*fine);
        break;
    }
    return mesh.triangles.size() - before;
}

}  // namespace vantage
