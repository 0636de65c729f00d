#include "pipeline/mesh/packed_model.h"

#include <algorithm>

#include "base/values/bytes_of.h"
#include "pipeline/mesh/clusters.h"

namespace vantage {

using package::Type;

namespace {

constexpr unsigned cluster_triangles = 256;

/// The new index of each vertex, by order of first use; unused vertices come last.
std::vector<std::uint32_t> first_use_order(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> order(vertices, unused);
    std::uint32_t next = 0;
    for (const std::uint32_t v : indices)
        if (order[v] == unused) order[v] = next++;
    for (std::uint32_t& o : order)
        if (o == unused) o = next++;
    return order;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    if (values.empty()) return;
    std::vector<T> permuted(values.size());
    for (std::size_t v = 0; v < values.size(); ++v) permuted[order[v]] = values[v];
    values = std::move(permuted);
}

void order_vertices(PackedModel& m, Mesh& mesh) {
    const std::vector<std::uint32_t> order = first_use_order(m.indices, m.positions.size());
    permute(m.positions, order);
    permute(mesh.positions, order);
    permute(mesh.normals, order);
    permute(mesh.colors, order);
    for (VertexField& field : mesh.scalars) permute(field.values, order);
    for (std::uint32_t& v : m.indices) v = order[v];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        std::copy_n(m.indices.begin() + std::ptrdiff_t(3 * t), 3, mesh.triangles[t].begin());
}

/// Orders the triangles by cluster; translucent ones come last.
void cluster_in_two_parts(PackedModel& m, const Mesh& mesh, const Eigen::AlignedBox3f& scene) {
    std::vector<std::uint32_t> opaque, transparent;
    for (std::size_t t = 0; t < m.indices.size() / 3; ++t) {
        auto& part = is_transparent(m.indices, t, mesh.colors) ? transparent : opaque;
        part.insert(part.end(), m.indices.begin() + std::ptrdiff_t(3 * t),
                    m.indices.begin() + std::ptrdiff_t(3 * t + 3));
    }
    m.clusters = make_clusters(m.positions, opaque, cluster_triangles, scene);
    const auto first = std::uint32_t(opaque.size() / 3);
    for (package::ClusterRecord c : make_clusters(m.positions, transparent, cluster_triangles, scene)) {
        c.first_triangle += first;
        m.clusters.push_back(c);
    }
    m.indices = std::move(opaque);
    m.indices.insert(m.indices.end(), transparent.begin(), transparent.end());
}

}  // namespace

PackedModel pack_model(Mesh& mesh, const MainBox& box, bool transparency) {
    PackedModel m;
    m.origin = box.low + (box.high - box.low) / 2;
    m.positions.reserve(mesh.positions.size());
    for (const Eigen::Vector3d& p : mesh.positions) m.positions.push_back((p - m.origin).cast<float>());
    for (const auto& t : mesh.triangles) m.indices.insert(m.indices.end(), t.begin(), t.end());
    const auto from_origin = [&](const Eigen::Vector3d& p) { return (p - m.origin).cast<float>().eval(); };
    const Eigen::AlignedBox3f scene = box.strays.empty()
                                          ? Eigen::AlignedBox3f()
                                          : Eigen::AlignedBox3f(from_origin(box.low), from_origin(box.high));
    if (transparency)
        cluster_in_two_parts(m, mesh, scene);
    else
        m.clusters = make_clusters(m.positions, m.indices, cluster_triangles, scene);
    order_vertices(m, mesh);
    m.opaque = transparency
                   ? opaque_part(m.clusters, m.indices, mesh.colors)
                   : OpaquePart{std::uint32_t(m.clusters.size()), std::uint32_t(m.indices.size() / 3),
                                std::uint32_t(m.positions.size())};
    Eigen::Map<Eigen::Vector3d>(m.record.origin) = m.origin;
    Eigen::Map<Eigen::Vector3d>(m.record.bounds_min) = box.low;
    Eigen::Map<Eigen::Vector3d>(m.record.bounds_max) = box.high;
    m.record.vertices = m.positions.size();
    m.record.triangles = m.indices.size() / 3;
    m.record.clusters = m.clusters.size();
    return m;
}

void write_model(PackageWriter& writer, const PackedModel& m, const Mesh& mesh) {
    const auto put = [&](Type type, std::span<const std::byte> bytes) {
        writer.write(type, package::scene_wide, bytes);
    };
    put(Type::positions, bytes_of(m.positions));
    put(Type::normals, bytes_of(mesh.normals));
    put(Type::indices, bytes_of(m.indices));
    put(Type::clusters, bytes_of(m.clusters));
    if (!mesh.colors.empty()) put(Type::colors, bytes_of(mesh.colors));
    if (mesh.scalars.empty()) return;
    std::vector<float> all;
    for (const VertexField& field : mesh.scalars)
        all.insert(all.end(), field.values.begin(), field.values.end());
    put(Type::scalars, bytes_of(all));
}

}  // namespace vantage
