#include "pipeline/reports/extract.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <ostream>

#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/values/bytes_of.h"
#include "base/values/tiling.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/stages/tile_levels.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/contents/scalar_field.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/damaged_package.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

using package::Type;
namespace fs = std::filesystem;

constexpr const char *mesh_name = "mesh.ply", *points_name = "points.ply", *cameras_name = "sparse",
                     *photos_name = "photos";

/// The files made from a photo.
struct PhotoFiles {
    fs::path photo, weight_maps, depth;
    Product photo_format;
};
/// What to extract, and where to write it.
struct Extraction {
    const PackageReader& reader;
    fs::path folder;
    bool undistorted;
    std::vector<std::string> stems;  ///< file names per photo, without extension

    /// The lens of the extracted photo. There is none if the photo is undistorted, on request or because
    /// COLMAP has no such lens.
    Lens lens(std::uint32_t photo) const {
        const Lens lens = lens_of(reader, photo);
        return undistorted || !has_colmap_model(lens) ? Lens{} : lens;
    }
    PhotoFiles files(std::uint32_t photo) const {
        const package::DirectoryEntry* finest = reader.find(Type::tiles, photo);
        const bool as_taken = lens(photo).distorts() == lens_of(reader, photo).distorts(),
                   own = finest && finest->form == package::Form::cells && as_taken;
        const std::string& stem = stems[photo];
        return {folder / photos_name / (stem + (own ? ".jpg" : ".png")), folder / "weights" / (stem + ".png"),
                folder / "depth" / (stem + ".exr"), own ? Product::jpeg : Product::png};
    }
    /// The first line of the camera files. It states whether the folder holds original or undistorted photos.
    std::string comment() const {
        return undistorted ? "# Cameras of the extracted photos, undistorted\n"
                           : "# Cameras of the extracted photos, as taken\n";
    }
};

/// For each photo, the name of its files without extension, including a folder for the image set if there are
/// several.
std::vector<std::string> stems_of(const PackageReader& reader, const std::vector<ImageSet>& image_sets) {
    std::vector<std::string> stems = reader.photo_stems();
    if (image_sets.size() > 1)
        for (std::size_t i = 0; i < stems.size(); ++i)
            stems[i] = image_sets[reader.photos()[i].image_set].name + "/" + stems[i];
    return stems;
}

void write_mesh(const PackageReader& reader, const fs::path& file) {
    const package::SceneRecord& s = reader.scene();
    std::vector<PlyField> fields;
    for (const ScalarField& field : read_fields(reader)) fields.push_back({field.name, field.values});
    std::span<const std::array<std::uint8_t, 4>> colors;
    if (effect_on(s, Effect::transparency))
        colors = reader.records<std::array<std::uint8_t, 4>>(Type::colors);
    write_ply(file, {.origin = Eigen::Map<const Eigen::Vector3d>(s.origin),
                     .positions = reader.records<Eigen::Vector3f>(Type::positions),
                     .normals = reader.records<Eigen::Vector3f>(Type::normals),
                     .triangles = reader.records<std::array<std::uint32_t, 3>>(Type::indices),
                     .fields = fields,
                     .colors = colors});
}

/// Writes the points node by node, from coarse to fine.
void write_points(const PackageReader& reader, const PointCloud& cloud, const fs::path& file) {
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(reader.scene().origin);
    const package::DirectoryEntry& chunk = *reader.find(Type::points);
    write_points_ply(file, cloud.points, [&](const std::function<void(const PlyPoint&)>& put) {
        for (const package::PointNode& node : cloud.nodes) {
            const auto block = reader.valid_block(chunk, node.block);
            for (std::uint32_t i = 0; i < node.count; ++i) {
                package::PackedPoint p;
                std::memcpy(&p, block.data() + (node.first + i) * sizeof p, sizeof p);
                put({origin + unpacked(p, node), {p.color[0], p.color[1], p.color[2]}});
            }
        }
    });
}

/// The photo's own JPEG, with a comment that identifies it as extracted.
void write_jpeg(const PackageReader& reader, const package::DirectoryEntry& tiles, const Level& level,
                const fs::path& file) {
    const auto jpeg = holds_level(reader, tiles, level) ? own_jpeg(reader, tiles) : std::nullopt;
    if (!jpeg)
        throw DamagedPackage(Defect::tile_checksum, reader.path().string() + ": " + describe(tiles, reader) +
                                                        ": the photo is damaged");
    constexpr std::size_t start_of_image = 2;
    const std::size_t length = jpeg_mark.size() + 2;
    const char comment[] = {'\xff', '\xfe', char(length >> 8), char(length & 0xff)};
    const auto* bytes = reinterpret_cast<const char*>(jpeg->data());
    replace_file(file, [&](std::ostream& out) {
        out.write(bytes, start_of_image).write(comment, sizeof comment) << jpeg_mark;
        out.write(bytes + start_of_image, std::streamsize(jpeg->size() - start_of_image));
    });
}

void write_pinhole(const PackageReader& reader, std::uint32_t i, const fs::path& file) {
    const RgbaImage image = read_pinhole_level(reader, reader.photos()[i], i, 0);
    image_files().write(file, image.width, image.height, 4, Sample::u8, bytes_of(image.rgba));
}

void write_photo(const Extraction& to, std::uint32_t i) {
    const PackageReader& reader = to.reader;
    const package::PhotoRecord& p = reader.photos()[i];
    const auto image = [&](Type type, std::uint32_t l, const fs::path& file, int channels, Sample format) {
        const Level size = level_size(int(p.width), int(p.height), int(l));
        const auto* e = reader.find(type, i, l);
        if (!e) throw Error(Exit::damaged, std::string(p.name) + ": a pyramid level is missing");
        image_files().write(file, size.width, size.height, channels, format, join_tiles(reader, *e, size));
    };
    const PhotoFiles files = to.files(i);
    for (const fs::path& file : {files.photo, files.weight_maps, files.depth})
        make_folder(file.parent_path());
    if (files.photo_format == Product::jpeg)
        write_jpeg(reader, *reader.find(Type::tiles, i), level_size(int(p.width), int(p.height), 0),
                   files.photo);
    else if (to.lens(i).distorts())
        image(Type::tiles, 0, files.photo, 4, Sample::u8);
    else
        write_pinhole(reader, i, files.photo);
    image(Type::weight_maps, weight_map_level, files.weight_maps, 4, Sample::u8);
    image(Type::depth, weight_map_level, files.depth, 1, Sample::f32);
}

/// The cameras of all photos in the folder, including those written by earlier calls, in the input's
/// coordinates.
std::vector<NamedCamera> extracted_cameras(const Extraction& to) {
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(to.reader.scene().origin);
    std::vector<NamedCamera> out;
    for (std::uint32_t i = 0; i < to.stems.size(); ++i) {
        const package::PhotoRecord& p = to.reader.photos()[i];
        const fs::path photo = to.files(i).photo;
        if (p.levels && fs::exists(photo))
            out.push_back({photo.lexically_relative(to.folder / photos_name).generic_string(),
                           {intrinsics(p), to.lens(i), cam_from_origin(p).relative_to(-origin)}});
    }
    return out;
}

/// Throws if the folder holds photos of the other kind (original or undistorted), because the cameras would
/// not match them.
void expect_same_way(const Extraction& to) {
    const fs::path file = to.folder / cameras_name / colmap_text_files[0];
    std::ifstream in(file);
    for (std::string line; std::getline(in, line) && line.starts_with("#");)
        if (line.starts_with("# Cameras of the extracted photos") && line + "\n" != to.comment())
            throw Error(Exit::usage, fmt::format("{}: already holds photos {}, expected a different folder",
                                                 to.folder.string(),
                                                 to.undistorted ? "as taken" : "without their distortion"));
}

void expect_replaceable(const Extraction& to, const std::vector<std::uint32_t>& wanted, bool force) {
    const PackageReader& reader = to.reader;
    const fs::path& folder = to.folder;
    const Inputs inputs = inputs_of(reader);
    if (!points_only(reader.scene())) output_file(folder / mesh_name, Product::ply, inputs, force);
    if (effect_on(reader.scene(), Effect::points))
        output_file(folder / points_name, Product::ply, inputs, force);
    for (const char* file : colmap_text_files)
        if (!wanted.empty()) output_file(folder / cameras_name / file, Product::cameras, inputs, force);
    for (const std::uint32_t i : wanted) {
        const PhotoFiles files = to.files(i);
        output_file(files.photo, files.photo_format, inputs, force);
        output_file(files.weight_maps, Product::png, inputs, force);
        output_file(files.depth, Product::exr, inputs, force);
    }
}

}  // namespace

Extracted extract(const fs::path& package, const fs::path& folder, const std::vector<std::string>& names,
                  bool undistorted, bool force) {
    const PackageReader reader(package);
    const auto photos = reader.photos();
    std::vector<std::uint32_t> wanted;
    for (const std::string& n : names) {
        const auto i = reader.photo_index(n);
        if (!i) throw Error(Exit::usage, package.string() + ": has no photo " + n);
        if (photos[*i].levels == 0)
            throw Error(Exit::usage, package.string() + ": has no pixels for " + photos[*i].name +
                                         ", which was held out or could not be read");
        if (!std::ranges::count(wanted, *i)) wanted.push_back(*i);
    }
    if (names.empty())
        for (std::uint32_t i = 0; i < photos.size(); ++i) wanted.push_back(i);
    std::erase_if(wanted, [&](std::uint32_t i) { return photos[i].levels == 0; });
    const Extraction to{reader, folder, undistorted && effect_on(reader.scene(), Effect::undistortion),
                        stems_of(reader, read_image_sets(reader))};
    if (!wanted.empty()) expect_same_way(to);
    expect_replaceable(to, wanted, force);
    for (const std::uint32_t i : wanted) write_photo(to, i);
    // The comment distinguishes extracted photos from inputs written by synth, which are never replaced.
    if (!wanted.empty()) write_colmap_text(folder / cameras_name, extracted_cameras(to), to.comment());
    Extracted out{.photos = wanted.size()};
    if (!points_only(reader.scene())) {
        write_mesh(reader, folder / mesh_name);
        out.vertices = reader.scene().vertices, out.triangles = reader.scene().triangles;
    }
    if (const auto cloud = read_point_cloud(reader)) {
        write_points(reader, *cloud, folder / points_name);
        out.points = cloud->points;
    }
    return out;
}

}  // namespace vantage
