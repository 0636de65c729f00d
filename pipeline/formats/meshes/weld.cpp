#include "pipeline/formats/meshes/weld.h"

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace vantage {
namespace {

/// The bits of position, normal and color, which can be compared even if normals are NaN.
using Key = std::array<std::uint64_t, 5>;

struct Hash {
    std::size_t operator()(const Key& key) const {
        return std::hash<std::string_view>()({reinterpret_cast<const char*>(key.data()), sizeof key});
    }
};

Key key_of(const Mesh& mesh, std::uint32_t v) {
    std::array<std::uint32_t, 4> rest{};
    if (!mesh.normals.empty())
        for (int i = 0; i < 3; ++i) rest[std::size_t(i)] = std::bit_cast<std::uint32_t>(mesh.normals[v][i]);
    if (!mesh.colors.empty()) rest[3] = std::bit_cast<std::uint32_t>(mesh.colors[v]);
    const auto words = std::bit_cast<std::array<std::uint64_t, 2>>(rest);
    const auto coordinate = [&](int i) { return std::bit_cast<std::uint64_t>(mesh.positions[v][i] + 0.0); };
    return {coordinate(0), coordinate(1), coordinate(2), words[0], words[1]};  // + 0.0: -0 is 0
}

/// For each vertex, the first vertex that is equal to it.
std::vector<std::uint32_t> first_equals(const Mesh& mesh) {
    std::unordered_map<Key, std::uint32_t, Hash> known;
    std::vector<std::uint32_t> first(mesh.positions.size());
    for (std::uint32_t v = 0; v < first.size(); ++v)
        first[v] = known.try_emplace(key_of(mesh, v), v).first->second;
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
