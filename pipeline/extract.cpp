#include "pipeline/extract.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <fstream>

#include "scene/error.h"
#include "scene/package_reader.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

using package::Type;
namespace fs = std::filesystem;

/// Puts the tiles of a level together again: width * height 4-byte texels.
std::vector<std::byte> join_tiles(const PackageReader& reader, const package::DirectoryEntry& e,
                                  const Level& level) {
    if (reader.blocks(e) != std::size_t(level.tiles()) || e.block_length != tile_bytes)
        throw Error(Exit::damaged, describe(e, reader) + ": does not have the tiles of its size");
    std::vector<std::byte> out(std::size_t(level.width) * std::size_t(level.height) * 4);
    for (int y = 0; y < level.height; ++y)
        for (int column = 0; column < level.columns(); ++column) {
            const int tile = (y / tile_content) * level.columns() + column, x = column * tile_content;
            const int n = std::min(tile_content, level.width - x);
            const auto from = reader.block(e, std::size_t(tile));
            std::memcpy(
                out.data() + (std::size_t(y) * std::size_t(level.width) + std::size_t(x)) * 4,
                from.data() + (std::size_t(y % tile_content + tile_border) * tile_size + tile_border) * 4,
                std::size_t(n) * 4);
        }
    return out;
}

void write_image(const fs::path& file, const Level& size, int channels, OIIO::TypeDesc type,
                 const std::byte* texels) {
    const auto out = OIIO::ImageOutput::create(file.string());
    OIIO::ImageSpec spec(size.width, size.height, channels, type);
    if (channels == 4) {
        spec.alpha_channel = 3;
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    if (!out || !out->open(file.string(), spec) || !out->write_image(type, texels) || !out->close())
        throw Error(Exit::storage, file.string() + ": cannot write" + (out ? ": " + out->geterror() : ""));
}

void write_mesh(const PackageReader& reader, const fs::path& file) {
    const package::SceneRecord& s = reader.scene();
    std::ofstream out(file, std::ios::binary);
    out << fmt::format(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
        "property double z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n",
        s.vertices, s.triangles);
    const auto put = [&](const auto& v) { out.write(reinterpret_cast<const char*>(&v), sizeof v); };
    const auto normals = reader.records<std::array<float, 3>>(Type::normals);
    std::size_t i = 0;
    for (const auto& p : reader.records<std::array<float, 3>>(Type::positions)) {
        for (std::size_t c = 0; c < 3; ++c) put(s.origin[c] + double(p[c]));
        put(normals[i++]);
    }
    for (const auto& t : reader.records<std::array<std::uint32_t, 3>>(Type::indices)) {
        put(std::uint8_t(3));
        put(t);
    }
    if (!out.flush()) throw Error(Exit::storage, file.string() + ": cannot write");
}

void write_photo(const PackageReader& reader, std::uint32_t i, const package::PhotoRecord& p,
                 const fs::path& folder) {
    const std::string name = p.name, stem = name.substr(0, name.rfind('.'));
    const auto image = [&](Type type, std::uint32_t l, const fs::path& file, int channels,
                           OIIO::TypeDesc format) {
        const Level size = level_size(int(p.width), int(p.height), int(l));
        const auto* e = reader.find(type, i, l);
        if (!e) throw Error(Exit::damaged, name + ": a level is missing");
        write_image(file, size, channels, format, join_tiles(reader, *e, size).data());
    };
    image(Type::tiles, 0, folder / "photos" / (stem + ".png"), 4, OIIO::TypeDesc::UINT8);
    image(Type::masks, mask_level, folder / "masks" / (stem + ".png"), 4, OIIO::TypeDesc::UINT8);
    image(Type::depth, mask_level, folder / "depth" / (stem + ".exr"), 1, OIIO::TypeDesc::FLOAT);
}

}  // namespace

void extract(const fs::path& package, const fs::path& folder, const std::vector<std::string>& names) {
    const PackageReader reader(package);
    for (const char* sub : {"photos", "masks", "depth"}) fs::create_directories(folder / sub);
    const auto photos = reader.photos();
    std::vector<std::uint32_t> wanted;
    for (const std::string& n : names) {
        const auto i = reader.photo_index(n);
        if (!i) throw Error(Exit::usage, package.string() + ": has no photo " + n);
        wanted.push_back(*i);
    }
    if (names.empty())
        for (std::uint32_t i = 0; i < photos.size(); ++i) wanted.push_back(i);
    for (const std::uint32_t i : wanted)
        if (photos[i].levels) write_photo(reader, i, photos[i], folder);
    write_mesh(reader, folder / "mesh.ply");
}

}  // namespace vantage
