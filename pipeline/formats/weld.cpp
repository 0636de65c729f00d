#include "pipeline/formats/weld.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace vantage {
namespace {

/// For each vertex the first one that is equal to it.
std::vector<std::uint32_t> first_equals(const Mesh& mesh) {
    const auto key = [&](std::uint32_t v) {
        const Eigen::Vector3d& p = mesh.positions[v];
        std::array<std::uint32_t, 4> rest{};  // bits, because normals may be NaN, which has no order
        if (!mesh.normals.empty())
            for (int i = 0; i < 3; ++i)
                rest[std::size_t(i)] = std::bit_cast<std::uint32_t>(mesh.normals[v][i]);
        if (!mesh.colors.empty()) rest[3] = std::bit_cast<std::uint32_t>(mesh.colors[v]);
        return std::tuple(p.x(), p.y(), p.z(), rest);
    };
    std::vector<std::uint32_t> order(mesh.positions.size()), first(order.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(key(a), a) < std::tuple(key(b), b);
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool repeats = i > 0 && key(order[i]) == key(order[i - 1]);
        first[order[i]] = repeats ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

void weld(Mesh& mesh) {
    const std::vector<std::uint32_t> first = first_equals(mesh);
    std::vector<std::uint32_t> merged(first.size());
    Mesh out;
    for (std::uint32_t v = 0; v < first.size(); ++v) {
        merged[v] = first[v] == v ? std::uint32_t(out.positions.size()) : merged[first[v]];
        if (first[v] != v) continue;
        out.positions.push_back(mesh.positions[v]);
        if (!mesh.normals.empty()) out.normals.push_back(mesh.normals[v]);
        if (!mesh.colors.empty()) out.colors.push_back(mesh.colors[v]);
    }
    for (const auto& t : mesh.triangles)
        if (const std::array<std::uint32_t, 3> w{merged[t[0]], merged[t[1]], merged[t[2]]};
            w[0] != w[1] && w[1] != w[2] && w[2] != w[0])
            out.triangles.push_back(w);
    mesh = std::move(out);
}

}  // namespace vantage
