#include "pipeline/reports/check.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "base/text/file_name.h"
#include "base/values/tiling.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/image_set_groups.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/output/stage_keys.h"
#include "pipeline/output/staleness.h"
#include "pipeline/run/files_below.h"
#include "pipeline/stages/surface_samples.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/contents/stored_tile.h"
#include "scene/package/mismatches.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_shape.h"
#include "scene/remote/remote_package.h"
#include "scene/story/story_file.h"
#include "scene/story/story_references.h"

namespace vantage {
namespace {

using package::Type;
using Issues = std::vector<Issue>;

void add(Issues& out, Finding finding, std::string text) { out.push_back({finding, std::move(text)}); }

void check_model(const PackageReader& reader, Issues& out) {
    for (const auto& p : reader.records<std::array<float, 3>>(Type::positions))
        if (!std::isfinite(p[0] + p[1] + p[2])) {
            add(out, Finding::non_finite_position, "VPOS: a position is not finite");
            break;
        }
    for (const auto& n : reader.records<std::array<float, 3>>(Type::normals))
        if (!(std::abs(std::hypot(n[0], n[1], n[2]) - 1) < 1e-3f)) {
            add(out, Finding::normal_length, "VNRM: a normal does not have unit length");
            break;
        }
}

void check_photo(const PackageReader& reader, const package::PhotoRecord& p, std::uint32_t i, Issues& out) {
    const bool without_pixels = p.flags & (package::photo_held_out | package::photo_skipped);
    if (without_pixels != (p.levels == 0))
        add(out, Finding::level_flag_mismatch,
            fmt::format("{}: the flags contradict the number of levels", p.name));
    if (without_pixels) return;
    const auto uvs = reader.records<std::array<float, 2>>(Type::coordinates, i, false);
    for (const auto& uv : uvs) {
        const bool marked = uv[0] == -1 && uv[1] == -1;
        if (!marked && !(uv[0] >= 0 && uv[0] <= 1 && uv[1] >= 0 && uv[1] <= 1)) {
            add(out, Finding::coordinate_range,
                fmt::format("{}: a texture coordinate is outside the photo, but not marked as unseen",
                            p.name));
            break;
        }
    }
    // The player does not need this chunk.
    if (!reader.find(Type::samples, i))
        add(out, Finding::chunk_length, fmt::format("{}: SAMP is missing", p.name));
}

/// Checks that depth is positive or +inf, and that a texel of the weight map is valid if and only if its
/// depth is finite.
void check_weight_meaning(const PackageReader& reader, std::uint32_t i, std::uint32_t level, Issues& out) {
    const package::PhotoRecord& p = reader.photos()[i];
    const Level size = level_size(int(p.width), int(p.height), int(level));
    const auto* weight_maps = reader.find(Type::weight_maps, i, level);
    const auto* depth = reader.find(Type::depth, i, level);
    if (!weight_maps || !depth) return;
    std::vector<std::byte> m(tile_bytes), d(tile_bytes);
    for (std::size_t b = 0; b < std::size_t(size.tiles()); ++b) {
        if (!read_tile(reader, *weight_maps, size, b, m) || !read_tile(reader, *depth, size, b, d)) {
            add(out, Finding::weight_depth_mismatch,
                describe(*weight_maps, reader) + fmt::format(": tile {} cannot be decoded", b));
            return;
        }
        for (std::size_t t = 0; t < tile_bytes; t += 4) {
            float z;
            std::memcpy(&z, d.data() + t, 4);
            if (!(z > 0) || (std::isfinite(z) != (std::to_integer<int>(m[t + 3]) > 0))) {
                add(out, Finding::weight_depth_mismatch,
                    describe(*weight_maps, reader) + fmt::format(": tile {} contradicts the depth", b));
                return;
            }
        }
    }
}

void check_states(const PackageReader& reader, Issues& out) {
    const auto photos = reader.photos();
    const auto states = reader.records<package::PhotoState>(Type::states);
    if (states.size() != photos.size())
        return add(out, Finding::chunk_length,
                   "STAT: the number of entries differs from the number of photos");
    for (std::size_t i = 0; i < photos.size(); ++i)
        if (!sealed(states[i], photos[i]))
            add(out, Finding::state_record_mismatch,
                fmt::format("STAT: the entry of {} does not match its record", photos[i].name));
}

/// The error message without the path of the package.
std::string text_of(const Error& e, const std::filesystem::path& file) {
    std::string text = e.what();
    if (text.starts_with(file.string() + ": ")) text.erase(0, file.string().size() + 2);
    return text;
}

void check_points(const PackageReader& reader, Issues& out) {
    try {
        read_point_cloud(reader);
    } catch (const Error& e) {
        add(out, Finding::misshapen, text_of(e, reader.path()));
    }
}

void check_structure(const PackageReader& reader, bool deep, Issues& out) {
    for (Mismatch& m : mismatches(reader, deep)) add(out, finding_of(m.defect), std::move(m.text));
    if (!out.empty()) return;
    for (std::string& line : misshapen(reader)) add(out, Finding::misshapen, std::move(line));
    if (!out.empty()) return;
    check_model(reader, out);
    check_points(reader, out);
    check_states(reader, out);
    const auto photos = reader.photos();
    for (std::uint32_t i = 0; i < photos.size(); ++i) {
        check_photo(reader, photos[i], i, out);
        for (int l = weight_map_level; deep && l < weight_map_levels_end(int(photos[i].levels)); ++l)
            check_weight_meaning(reader, i, std::uint32_t(l), out);
    }
}

Finding finding_of(InputChange::Kind kind) {
    if (kind == InputChange::Kind::changed) return Finding::input_changed;
    return kind == InputChange::Kind::added ? Finding::input_new : Finding::input_missing;
}

void check_against(const PackageReader& reader, const CheckDepth& depth, Issues& out) {
    std::optional<IdentityCache> default_cache;
    IdentityCache& identities = depth.identities ? *depth.identities : default_cache.emplace();
    // Reference meshes and point clouds may be anywhere in the folder.
    InputFiles others;
    for (const auto& [list, files] :
         {std::pair("compared", &others.compared), std::pair("points", &others.points)}) {
        if (!std::filesystem::is_directory(depth.against)) break;  // discover() reports this
        const std::vector<std::string> names = names_listed(reader, list);
        for (const std::filesystem::path& file : files_below(depth.against, 2))
            if (std::ranges::count(names, utf8_name(file.filename().string())) > 0) files->push_back(file);
    }
    others.image_sets = image_sets_wanted(reader);
    if (is_image_sets_file(others.image_sets)) {
        const std::string name = std::exchange(others.image_sets, image_sets_off);
        for (const std::filesystem::path& file : files_below(depth.against, 2))
            if (utf8_name(file.filename().string()) == name) others.image_sets = file.string();
    }
    for (const InputChange& change : changed_inputs(reader, discover(depth.against, others), identities))
        add(out, finding_of(change.kind), change.text);
}

/// The box that encloses all vertices and the bounds of the scene, in the input's coordinates.
Eigen::AlignedBox3d whole_box(const PackageReader& reader) {
    const package::SceneRecord& scene = reader.scene();
    const Eigen::Map<const Eigen::Vector3d> origin(scene.origin);
    Eigen::AlignedBox3d box;
    box.extend(Eigen::Map<const Eigen::Vector3d>(scene.bounds_min));
    box.extend(Eigen::Map<const Eigen::Vector3d>(scene.bounds_max));
    for (const auto& p : reader.records<std::array<float, 3>>(Type::positions))
        box.extend(origin + Eigen::Vector3d(double(p[0]), double(p[1]), double(p[2])));
    return box;
}

/// Checks the story beside the package, if there is one.
void check_story(const PackageReader& reader, Issues& out) {
    const std::filesystem::path file = story_file_of(reader.path());
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(std::filesystem::symlink_status(file, error))) return;
    const auto add_all = [&](Finding finding, const std::vector<std::string>& lines) {
        for (const std::string& line : lines) add(out, finding, file.filename().string() + ": " + line);
    };
    try {
        const auto [story, unknown] = read_story(file);
        add_all(Finding::story_reference, dangling_references(story));
        add_all(Finding::story_picture, missing_pictures(story, file.parent_path()));
        add_all(Finding::story_anchor, anchors_outside(story, whole_box(reader)));
        add_all(Finding::story_unknown_key, unknown);
    } catch (const Error& e) {
        add_all(Finding::story_unreadable, {text_of(e, file)});
    }
}

}  // namespace

Exit worst(const Issues& issues) {
    for (const Exit kind : {Exit::input, Exit::damaged, Exit::stale, Exit::incomplete})
        if (std::ranges::any_of(issues, [&](const Issue& i) { return i.row().kind == kind; })) return kind;
    return Exit::ok;
}

Issues check_package(const std::filesystem::path& file, const CheckDepth& depth) {
    Issues out;
    Finding unreadable = Finding::cannot_open;
    try {
        const PackageReader reader = open_package(file);
        unreadable = Finding::input_unreadable;  // from here on, only inputs are opened
        check_structure(reader, depth.deep, out);
        if (!out.empty()) return out;
        if (!depth.against.empty()) check_against(reader, depth, out);
        for (const UnusablePhoto& l : skipped_of(reader))
            add(out, Finding::photo_skipped, l.photo + ": skipped: " + l.why);
        check_story(reader, out);
    } catch (const DamagedPackage& e) {
        add(out, finding_of(e.defect()), text_of(e, file));
    } catch (const Error& e) {
        if (e.code() != Exit::damaged && e.code() != Exit::input) throw;
        add(out, e.code() == Exit::input ? unreadable : Finding::invalid_meta, text_of(e, file));
    }
    return out;
}

}  // namespace vantage
