#include "scene/package/package_shape.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "base/text/error.h"
#include "base/text/photo_names.h"
#include "base/values/tiling.h"
#include "scene/package/chunk_table.h"
#include "scene/package/contents/background.h"
#include "scene/package/contents/opaque_part.h"
#include "scene/package/contents/stored_tile.h"

namespace vantage {
namespace {

using package::DirectoryEntry;
using package::PhotoRecord;
using package::Type;
using Lines = std::vector<std::string>;

void model_shape(const PackageReader& reader, const package::SceneRecord& scene, Lines& out) {
    const auto indices = reader.records<std::uint32_t>(Type::indices);
    const auto beyond = std::ranges::find_if(indices, [&](std::uint32_t i) { return i >= scene.vertices; });
    if (beyond != indices.end())
        out.push_back("INDX: index " + std::to_string(*beyond) + ", but there are " +
                      std::to_string(scene.vertices) + " vertices");
    const auto clusters = reader.records<package::ClusterRecord>(Type::clusters);
    std::uint64_t next = 0;
    bool covered = true;
    for (const package::ClusterRecord& c : clusters) {
        covered &= c.first_triangle == next;
        next = std::uint64_t(c.first_triangle) + c.triangles;
        if (!std::isfinite(c.center[0] + c.center[1] + c.center[2]) || !(c.radius >= 0) ||
            std::isinf(c.radius))
            out.push_back("CLUS: the sphere of cluster " + std::to_string(&c - clusters.data()) +
                          " is out of range");
    }
    if (!covered || next != scene.triangles) out.emplace_back("CLUS: clusters do not cover the triangles");
}

std::string without_path(const Error& e, const PackageReader& reader) {
    const std::string line = e.what(), path = reader.path().string() + ": ";
    return line.starts_with(path) ? line.substr(path.size()) : line;
}

void background_shape(const PackageReader& reader, Lines& out) {
    try {
        const bool present = read_background(reader).has_value();
        if (present != effect_on(reader.scene(), Effect::background))
            out.emplace_back(present ? "SURR: the effect is off" : "SURR is missing");
    } catch (const Error& e) {
        out.push_back(without_path(e, reader));
    }
}

void fields_shape(const PackageReader& reader, const package::SceneRecord& scene, Lines& out) {
    if (!effect_on(scene, Effect::scalar_fields)) return;
    const DirectoryEntry* e = reader.find(Type::scalars, package::scene_wide);
    const std::uint64_t field = scene.vertices * sizeof(float);
    if (!e || field == 0 || reader.content_length(e) % field != 0 ||
        reader.content_length(e) / field != scene.scalar_fields)
        out.emplace_back("VSCL does not have one value per vertex and field");
}

void image_sets_shape(const PackageReader& reader, const package::SceneRecord& scene, Lines& out) {
    const DirectoryEntry* e = reader.find(Type::image_sets);
    if ((e != nullptr) != effect_on(scene, Effect::image_sets)) {
        out.emplace_back(e ? "BAND: the effect is off" : "BAND is missing");
        return;
    }
    const auto image_sets =
        reader.records<package::ImageSetRecord>(Type::image_sets, package::scene_wide, false);
    if (e && (image_sets.size() < 2 || image_sets.size() > package::max_image_sets))
        out.push_back("BAND: has " + std::to_string(image_sets.size()) + " image sets, expected 2 to " +
                      std::to_string(package::max_image_sets));
    std::set<std::string> names;
    for (const package::ImageSetRecord& b : image_sets) {
        const std::string name(b.name, ::strnlen(b.name, sizeof b.name));
        if (name.size() == sizeof b.name || !is_image_set_name(name) || !names.insert(name).second)
            out.push_back("BAND: image set " + std::to_string(&b - image_sets.data()) +
                          " has a name that is not unique or cannot name a folder");
    }
}

void lenses_shape(const PackageReader& reader, const package::SceneRecord& scene, Lines& out) {
    const DirectoryEntry* e = reader.find(Type::lenses);
    if ((e != nullptr) != effect_on(scene, Effect::undistortion)) {
        out.emplace_back(e ? "LENS: the effect is off" : "LENS is missing");
        return;
    }
    if (e && reader.content_length(e) != chunk_row(Type::lenses).length(scene)) {
        out.emplace_back("LENS does not have one record per photo");
        return;
    }
    for (std::uint32_t i = 0; e && i < scene.photos; ++i) try {
            lens_of(reader, i);
        } catch (const DamagedPackage& damage) {
            out.push_back(without_path(damage, reader));
            return;
        }
}

void transparency_shape(const PackageReader& reader, Lines& out) {
    if (!out.empty()) return;  // transparency cannot be read from chunks with a wrong shape
    if (auto damage = transparency_damage(reader)) out.push_back(std::move(*damage));
}

void blocks_shape(const PackageReader& reader, Type type, std::uint32_t i, std::uint32_t level,
                  const Level& size, Lines& out) {
    const DirectoryEntry* e = reader.find(type, i, level);
    if (!e)
        out.push_back("photo " + std::to_string(i) + ": level " + std::to_string(level) + " is missing");
    else if (!holds_level(reader, *e, size))
        out.push_back(describe(*e, reader) + ": has " + std::to_string(reader.blocks(*e)) +
                      " tiles, expected " + std::to_string(size.tiles()));
}

void photo_shape(const PackageReader& reader, const package::SceneRecord& scene, const PhotoRecord& p,
                 std::uint32_t i, Lines& out) {
    for (const auto& [row, level] : chunks_of_photo(int(p.levels))) {
        if (row->levels != ChunkLevels::single) {
            blocks_shape(reader, row->type, i, level, level_size(int(p.width), int(p.height), int(level)),
                         out);
            continue;
        }
        const DirectoryEntry* e = reader.find(row->type, i);
        const bool may_be_missing = row->type == Type::samples || (row->type == Type::coordinates &&
                                                                   effect_on(scene, Effect::per_fragment));
        if (e ? e->form == package::Form::jpeg : may_be_missing) continue;
        if (reader.content_length(e) != row->length(scene, p))
            out.push_back(std::string(p.name) + ": " + fourcc_of(row->type) + " does not have " +
                          row->counted);
    }
}

}  // namespace

std::vector<std::string> misshapen(const PackageReader& reader) {
    Lines out;
    const package::SceneRecord& scene = reader.scene();
    model_shape(reader, scene, out);
    transparency_shape(reader, out);
    background_shape(reader, out);
    fields_shape(reader, scene, out);
    image_sets_shape(reader, scene, out);
    lenses_shape(reader, scene, out);
    const auto photos = reader.photos();
    for (std::uint32_t i = 0; i < photos.size(); ++i)
        if (photos[i].levels > 0) photo_shape(reader, scene, photos[i], i, out);
    return out;
}

bool has_coordinates(const PackageReader& package) {
    const auto photos = package.photos();
    const auto shown = std::ranges::find_if(photos, [](const auto& p) { return p.levels > 0; });
    return shown == photos.end() || package.find(Type::coordinates, std::uint32_t(shown - photos.begin()));
}

void expect_shape(const PackageReader& package) {
    if (const Lines lines = misshapen(package); !lines.empty())
        throw Error(Exit::damaged, package.path().string() + ": " + lines.front());
}

}  // namespace vantage
