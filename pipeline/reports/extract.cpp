#include "pipeline/reports/extract.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <ostream>

#include "files/make_folder.h"
#include "files/output_file.h"
#include "files/package_inputs.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/package/tile_levels.h"
#include "pipeline/photos/image_files.h"
#include "scene/bands.h"
#include "scene/damaged_package.h"
#include "scene/package_reader.h"
#include "scene/point_cloud.h"
#include "scene/replace_file.h"
#include "scene/stored_tile.h"
#include "scene/tiling.h"
#include "scene/value_layer.h"

namespace vantage {
namespace {

using package::Type;
namespace fs = std::filesystem;

constexpr const char *mesh_name = "mesh.ply", *points_name = "points.ply", *cameras_name = "sparse",
                     *photos_name = "photos";

/// The files made from a photo. The masks' name is not one by which `prepare` would find a stencil.
struct PhotoFiles {
    fs::path photo, masks, depth;
    Product photo_format;
};
/// `stem`: with the folder of its band, if there are several.
PhotoFiles files_of(const PackageReader& reader, std::uint32_t photo, const fs::path& folder,
                    const std::string& stem) {
    const package::DirectoryEntry* finest = reader.find(Type::tiles, photo);
    const bool own = finest && finest->form == package::Form::cells;
    return {folder / photos_name / (stem + (own ? ".jpg" : ".png")),
            folder / "masks" / (stem + ".weights.png"), folder / "depth" / (stem + ".exr"),
            own ? Product::jpeg : Product::png};
}

/// Per photo, the name of its files, in a folder of its band if there are several.
std::vector<std::string> stems_of(const PackageReader& reader, const std::vector<Band>& bands) {
    std::vector<std::string> stems = reader.photo_stems();
    if (bands.size() > 1)
        for (std::size_t i = 0; i < stems.size(); ++i)
            stems[i] = bands[reader.photos()[i].band].name + "/" + stems[i];
    return stems;
}

void write_mesh(const PackageReader& reader, const fs::path& file) {
    const package::SceneRecord& s = reader.scene();
    std::vector<PlyLayer> layers;
    for (const ValueLayer& layer : read_layers(reader)) layers.push_back({layer.name, layer.values});
    std::span<const std::array<std::uint8_t, 4>> colors;
    if (effect_on(s, Effect::transparency))
        colors = reader.records<std::array<std::uint8_t, 4>>(Type::colors);
    write_ply(file, Eigen::Map<const Eigen::Vector3d>(s.origin),
              reader.records<Eigen::Vector3f>(Type::positions),
              reader.records<Eigen::Vector3f>(Type::normals),
              reader.records<std::array<std::uint32_t, 3>>(Type::indices), layers, colors);
}

/// Node by node, coarse before fine.
void write_points(const PackageReader& reader, const PointCloud& cloud, const fs::path& file) {
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(reader.scene().origin);
    const package::DirectoryEntry& chunk = *reader.find(Type::points);
    write_points_ply(file, cloud.points, [&](const std::function<void(const PlyPoint&)>& put) {
        for (const package::PointNode& node : cloud.nodes) {
            const auto block = reader.sound_block(chunk, node.block);
            for (std::uint32_t i = 0; i < node.count; ++i) {
                package::PackedPoint p;
                std::memcpy(&p, block.data() + (node.first + i) * sizeof p, sizeof p);
                put({origin + unpacked(p, node), {p.color[0], p.color[1], p.color[2]}});
            }
        }
    });
}

/// The photo's own JPEG, with a comment by which it is known as one of ours.
void write_jpeg(const PackageReader& reader, const package::DirectoryEntry& tiles, const Level& level,
                const fs::path& file) {
    const auto jpeg = holds_level(reader, tiles, level) ? own_jpeg(reader, tiles) : std::nullopt;
    if (!jpeg)
        throw DamagedPackage(Defect::tile_checksum, reader.path().string() + ": " + describe(tiles, reader) +
                                                        ": a part of the photo is damaged");
    constexpr std::size_t start_of_image = 2;
    const std::size_t length = jpeg_mark.size() + 2;
    const char comment[] = {'\xff', '\xfe', char(length >> 8), char(length & 0xff)};
    const auto* bytes = reinterpret_cast<const char*>(jpeg->data());
    replace_file(file, [&](std::ostream& out) {
        out.write(bytes, start_of_image).write(comment, sizeof comment) << jpeg_mark;
        out.write(bytes + start_of_image, std::streamsize(jpeg->size() - start_of_image));
    });
}

void write_photo(const PackageReader& reader, std::uint32_t i, const package::PhotoRecord& p,
                 const std::string& stem, const fs::path& folder) {
    const auto image = [&](Type type, std::uint32_t l, const fs::path& file, int channels, Sample format) {
        const Level size = level_size(int(p.width), int(p.height), int(l));
        const auto* e = reader.find(type, i, l);
        if (!e) throw Error(Exit::damaged, std::string(p.name) + ": a pyramid level is missing");
        image_files().write(file, size.width, size.height, channels, format, join_tiles(reader, *e, size));
    };
    const PhotoFiles files = files_of(reader, i, folder, stem);
    for (const fs::path& file : {files.photo, files.masks, files.depth}) make_folder(file.parent_path());
    if (files.photo_format == Product::jpeg)
        write_jpeg(reader, *reader.find(Type::tiles, i), level_size(int(p.width), int(p.height), 0),
                   files.photo);
    else
        image(Type::tiles, 0, files.photo, 4, Sample::u8);
    image(Type::masks, mask_level, files.masks, 4, Sample::u8);
    image(Type::depth, mask_level, files.depth, 1, Sample::f32);
}

/// The cameras of all photos that are in the folder now, in the input's coordinates: those just written and
/// those of an earlier call.
std::vector<NamedCamera> extracted_cameras(const PackageReader& reader, const fs::path& folder,
                                           const std::vector<std::string>& stems) {
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(reader.scene().origin);
    std::vector<NamedCamera> out;
    for (std::uint32_t i = 0; i < stems.size(); ++i) {
        const package::PhotoRecord& p = reader.photos()[i];
        const fs::path photo = files_of(reader, i, folder, stems[i]).photo;
        if (p.levels && fs::exists(photo))
            out.push_back({photo.lexically_relative(folder / photos_name).generic_string(),
                           {intrinsics(p), {}, cam_from_origin(p).relative_to(-origin)}});
    }
    return out;
}

void expect_replaceable(const PackageReader& reader, const std::vector<std::uint32_t>& wanted,
                        const std::vector<std::string>& stems, const fs::path& folder, bool force) {
    const Inputs inputs = inputs_of(reader);
    if (!points_only(reader.scene())) output_file(folder / mesh_name, Product::ply, inputs, force);
    if (effect_on(reader.scene(), Effect::points))
        output_file(folder / points_name, Product::ply, inputs, force);
    for (const char* file : colmap_text_files)
        if (!wanted.empty()) output_file(folder / cameras_name / file, Product::cameras, inputs, force);
    for (const std::uint32_t i : wanted) {
        const PhotoFiles files = files_of(reader, i, folder, stems[i]);
        output_file(files.photo, files.photo_format, inputs, force);
        output_file(files.masks, Product::png, inputs, force);
        output_file(files.depth, Product::exr, inputs, force);
    }
}

}  // namespace

void extract(const fs::path& package, const fs::path& folder, const std::vector<std::string>& names,
             bool force) {
    const PackageReader reader(package);
    const auto photos = reader.photos();
    std::vector<std::uint32_t> wanted;
    for (const std::string& n : names) {
        const auto i = reader.photo_index(n);
        if (!i) throw Error(Exit::usage, package.string() + ": has no photo " + n);
        if (photos[*i].levels == 0)
            throw Error(Exit::usage, package.string() + ": has no pixels of " + photos[*i].name +
                                         ", which was held out or could not be read");
        if (!std::ranges::count(wanted, *i)) wanted.push_back(*i);
    }
    if (names.empty())
        for (std::uint32_t i = 0; i < photos.size(); ++i) wanted.push_back(i);
    std::erase_if(wanted, [&](std::uint32_t i) { return photos[i].levels == 0; });
    const std::vector<Band> bands = read_bands(reader);
    const std::vector<std::string> stems = stems_of(reader, bands);
    expect_replaceable(reader, wanted, stems, folder, force);
    for (const std::uint32_t i : wanted) write_photo(reader, i, photos[i], stems[i], folder);
    // The comment tells them apart from inputs written by synth, which are never replaced.
    if (!wanted.empty())
        write_colmap_text(folder / cameras_name, extracted_cameras(reader, folder, stems),
                          "# Cameras of the extracted photos\n");
    if (!points_only(reader.scene())) write_mesh(reader, folder / mesh_name);
    if (const auto cloud = read_point_cloud(reader)) write_points(reader, *cloud, folder / points_name);
}

}  // namespace vantage
