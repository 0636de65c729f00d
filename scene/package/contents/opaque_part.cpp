#include "scene/package/contents/opaque_part.h"

#include <algorithm>

namespace vantage {

using package::Type;

namespace {

using Color = std::array<std::uint8_t, 4>;

}  // namespace

OpaquePart opaque_part(std::span<const package::ClusterRecord> clusters,
                       std::span<const std::uint32_t> indices, std::span<const Color> colors) {
    const auto transparent = [&](const package::ClusterRecord& c) {
        return c.first_triangle < indices.size() / 3 && is_transparent(indices, c.first_triangle, colors);
    };
    const auto first = std::ranges::find_if(clusters, transparent);
    OpaquePart out{std::uint32_t(first - clusters.begin()), std::uint32_t(indices.size() / 3), 0};
    if (first != clusters.end()) out.triangles = first->first_triangle;
    for (const std::uint32_t v : indices.first(3 * std::size_t(out.triangles)))
        out.vertices = std::max(out.vertices, v + 1);
    return out;
}

OpaquePart opaque_part(const PackageReader& package) {
    const package::SceneRecord& scene = package.scene();
    if (!effect_on(scene, Effect::transparency))
        return {std::uint32_t(scene.clusters), std::uint32_t(scene.triangles), std::uint32_t(scene.vertices)};
    return opaque_part(package.records<package::ClusterRecord>(Type::clusters),
                       package.records<std::uint32_t>(Type::indices), package.records<Color>(Type::colors));
}

std::optional<std::string> transparency_damage(const PackageReader& package) {
    const package::SceneRecord& scene = package.scene();
    if (!effect_on(scene, Effect::transparency)) return {};
    const package::DirectoryEntry* e = package.find(Type::colors);
    if (package.content_length(e) != scene.vertices * sizeof(Color))
        return "VCOL does not have one color per vertex";
    const auto indices = package.records<std::uint32_t>(Type::indices);
    const auto colors = package.records<Color>(Type::colors);
    const OpaquePart opaque = opaque_part(package);
    for (std::size_t t = 0; t < indices.size() / 3; ++t)
        if (is_transparent(indices, t, colors) != (t >= opaque.triangles))
            return "CLUS: triangle " + std::to_string(t) + " is in a cluster of " +
                   (t >= opaque.triangles ? "transparent" : "opaque") + " triangles but is not one of them";
    return {};
}

}  // namespace vantage
