#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/files/checksum.h"
#include "base/values/bytes_of.h"
#include "base/values/tiling.h"
#include "scene/package/contents/background.h"
#include "scene/package/contents/effects.h"
#include "scene/package/package_writer.h"

namespace vantage::fuzz {

/// A background: a tetrahedron that surrounds the scene and is partly visible in the photo.
inline BackgroundContent valid_background() {
    BackgroundContent s;
    s.positions = {{0, 0, 9}, {9, 0, -9}, {-9, 9, -9}, {-9, -9, -9}};
    s.triangles = {{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    package::ClusterRecord c{};
    c.radius = 18, c.triangles = 4, c.cone_cutoff = 1;
    s.clusters = {c};
    s.colors.assign(4, {90, 120, 150, 255});
    package::CoverageRecord seen{};
    seen.seen = seen.u1 = seen.v1 = 65535;
    s.coverage = {{seen}};
    s.visible = {{0, 15}};
    return s;
}

/// A root node with two children in one block.
inline std::vector<package::PointNode> valid_nodes() {
    package::PointNode root{};
    root.low[0] = root.low[1] = root.low[2] = -1, root.size = 2, root.spacing = 0.1f;
    root.count = 5, root.children = 1, root.child_octants = 0x81;
    package::PointNode low = root, high = root;
    low.size = high.size = 1, low.spacing = high.spacing = 0.05f;
    low.first = 5, high.first = 10, low.child_octants = high.child_octants = 0;
    high.low[0] = high.low[1] = high.low[2] = 0;
    return {root, low, high};
}

/// A package with two triangles in one cluster, a transparent triangle in another, a background, a point
/// cloud, two image sets, and one photo of 40 x 30 pixels that sees the first two triangles. Contains only
/// the data that the player reads; fix_checksums() computes the checksums of heads, directory and header.
class ValidPackage {
  public:
    ValidPackage() {
        using package::Type;
        package::SceneRecord s{};
        for (int i = 0; i < 3; ++i) s.bounds_min[i] = -1, s.bounds_max[i] = 1;
        s.vertices = 5, s.triangles = 3, s.clusters = 2, s.photos = 1, s.reference_density = 20;
        s.border_width = 8, s.scalar_fields = 2;
        s.effects = effect_bit(Effect::background) | effect_bit(Effect::scalar_fields) |
                    effect_bit(Effect::points) | effect_bit(Effect::image_sets) |
                    effect_bit(Effect::transparency);
        package::PhotoRecord p{};
        std::strcpy(p.name, "a.jpg");
        p.width = 40, p.height = 30, p.levels = 1, p.thumbnail_width = 4, p.thumbnail_height = 3;
        p.weight_map_width = 20, p.weight_map_height = 15;
        p.fx = p.fy = 40, p.cx = 20, p.cy = 15, p.t[2] = 3, p.corrected_direction[2] = 1, p.hull_area = 0.5;
        p.R[0] = p.R[4] = p.R[8] = 1, p.seen_distance = 3, p.z_min = 2, p.z_max = 4;
        for (double& g : p.gain) g = 1;
        package::ClusterRecord c[2]{};
        c[0].radius = c[1].radius = 1.5f, c[0].triangles = c[1].first_triangle = 2, c[1].triangles = 1;
        const float positions[5][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, -1}};
        const std::uint32_t indices[9] = {0, 1, 2, 0, 2, 3, 0, 2, 4};
        const float normals[5][3] = {{0, 0, -1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
        const std::uint8_t colors[5][4] = {
            {255, 255, 255, 255}, {255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {9, 99, 199, 100}};
        const float coordinates[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, -1}};
        package::CoverageRecord seen[2]{};
        seen[0].u1 = seen[0].v1 = 65535;
        const std::uint64_t bits[2] = {3, 3};
        const std::byte thumbnail[48]{};
        add(Type::scene, package::scene_wide, 0, bytes_of_one(s));
        add(Type::photos, package::scene_wide, 0, bytes_of_one(p));
        add(Type::clusters, package::scene_wide, 0, std::as_bytes(std::span(c)));
        add(Type::positions, package::scene_wide, 0, std::as_bytes(std::span(positions)));
        add(Type::normals, package::scene_wide, 0, std::as_bytes(std::span(normals)));
        add(Type::indices, package::scene_wide, 0, std::as_bytes(std::span(indices)));
        add(Type::coordinates, 0, 0, std::as_bytes(std::span(coordinates)));
        add(Type::coverage, 0, 0, std::as_bytes(std::span(seen)));
        add(Type::visible, 0, 0, std::as_bytes(std::span(bits)));
        add(Type::thumbnail, 0, 0, thumbnail);
        const std::string meta = R"({"scalars":["height","?"]})";
        const float values[2][5] = {{0, 0, 1, 1, 2}, {-1, 2, std::numeric_limits<float>::quiet_NaN(), 3, 0}};
        add(Type::meta, package::scene_wide, 0, std::as_bytes(std::span(meta)));
        add(Type::scalars, package::scene_wide, 0, std::as_bytes(std::span(values)));
        add(Type::background, package::scene_wide, 0, background_chunk(valid_background()));
        const std::vector<package::PointNode> nodes = valid_nodes();
        add(Type::point_nodes, package::scene_wide, 0, bytes_of(nodes));
        add_points();
        add_tile(Type::tiles, 0);
        add_tile(Type::weight_maps, 1);
        add_tile(Type::depth, 1);
        package::ImageSetRecord image_sets[2]{{"visible", s.effects}, {"infrared", 0}};
        add(Type::image_sets, package::scene_wide, 0, std::as_bytes(std::span(image_sets)));
        add(Type::colors, package::scene_wide, 0, std::as_bytes(std::span(colors)));
        const std::size_t directory = bytes.size();
        bytes.resize(directory + entries.size() * sizeof(package::DirectoryEntry));
        std::memcpy(header.magic, package::magic, sizeof header.magic);
        header.version = package::version;
        header.directory_count = std::uint32_t(entries.size());
        header.directory_offset = directory;
        header.file_size = bytes.size();
        std::memcpy(bytes.data() + directory, entries.data(),
                    entries.size() * sizeof(package::DirectoryEntry));
        std::memcpy(bytes.data(), &header, sizeof header);
        parts = {{0, sizeof header}, {directory, entries.size() * sizeof(package::DirectoryEntry)}};
        for (const package::DirectoryEntry& e : entries) parts.emplace_back(e.offset, e.head_length);
    }
    std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(package::alignment);
    std::vector<package::DirectoryEntry> entries;
    package::Header header{};
    std::vector<std::pair<std::uint64_t, std::uint64_t>>
        parts;  ///< offset and length of everything except tiles

  private:
    package::DirectoryEntry& add(package::Type type, std::uint32_t photo, std::uint32_t level,
                                 std::span<const std::byte> head) {
        package::DirectoryEntry e{};
        e.type = std::uint32_t(type), e.photo = photo, e.level = level;
        e.offset = bytes.size(), e.length = e.head_length = head.size();
        bytes.resize((bytes.size() + head.size() + package::alignment - 1) / package::alignment *
                     package::alignment);
        std::memcpy(bytes.data() + e.offset, head.data(), head.size());
        return entries.emplace_back(e);
    }
    void add_points() {
        constexpr std::size_t block = package::point_block * sizeof(package::PackedPoint);
        const std::vector<std::byte> head(package::alignment), points(block);
        package::DirectoryEntry& e = add(package::Type::points, package::scene_wide, 0, head);
        const std::uint64_t sum = checksum(points);
        std::memcpy(bytes.data() + e.offset, &sum, sizeof sum);
        bytes.insert(bytes.end(), block, 0);
        e.length += block, e.block_length = block;
    }
    void add_tile(package::Type type, std::uint32_t level) {
        const std::vector<std::byte> head(package::alignment), tile(tile_bytes);
        package::DirectoryEntry& e = add(type, 0, level, head);
        const std::uint64_t sum = checksum(tile);
        std::memcpy(bytes.data() + e.offset, &sum, sizeof sum);
        bytes.insert(bytes.end(), tile_bytes, 0);
        e.length += tile_bytes, e.block_length = tile_bytes;
    }
};

/// Recomputes the checksums of heads, the directory and the header if the bytes that these cover are within
/// the file.
inline void fix_checksums(std::vector<std::uint8_t>& b) {
    package::Header h;
    std::memcpy(&h, b.data(), sizeof h);
    const auto sum = [&](std::uint64_t at, std::uint64_t length) {
        return checksum(std::as_bytes(std::span(b).subspan(at, length)));
    };
    if (h.directory_offset <= b.size() &&
        h.directory_count <= (b.size() - h.directory_offset) / sizeof(package::DirectoryEntry)) {
        for (std::uint32_t i = 0; i < h.directory_count; ++i) {
            std::uint8_t* at = b.data() + h.directory_offset + i * sizeof(package::DirectoryEntry);
            package::DirectoryEntry e;
            std::memcpy(&e, at, sizeof e);
            if (e.offset > b.size() || e.head_length > b.size() - e.offset) continue;
            e.checksum = sum(e.offset, e.head_length);
            std::memcpy(at, &e, sizeof e);
        }
        h.directory_checksum = sum(h.directory_offset, h.directory_count * sizeof(package::DirectoryEntry));
    }
    std::memcpy(b.data(), &h, sizeof h);
    h.header_checksum = sum(0, offsetof(package::Header, header_checksum));
    std::memcpy(b.data(), &h, sizeof h);
}

}  // namespace vantage::fuzz
