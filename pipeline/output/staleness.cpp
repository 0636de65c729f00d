#include "pipeline/output/staleness.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "base/text/json_text.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/image_set_groups.h"
#include "pipeline/input/masks.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/output/meta.h"
#include "scene/package/mismatches.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Changes = std::vector<InputChange>;

void add_missing(const std::string& file, Changes& out) {
    out.push_back({InputChange::Kind::missing, file + ": no longer exists"});
}

void add_new(const fs::path& file, Changes& out) {
    out.push_back({InputChange::Kind::added, file.string() + ": was added after the package was prepared"});
}

void add_changed(const fs::path& file, Changes& out) {
    out.push_back(
        {InputChange::Kind::changed, file.string() + ": has changed since the package was prepared"});
}

/// Compares a file and its companions listed in META.
void compare(const fs::path& file, const json& was, IdentityCache& identities, Changes& out) {
    if (!fs::exists(file)) return add_missing(file.string(), out);
    const bool same = fs::file_size(file) == was.at("bytes").get<std::uint64_t>() &&
                      identities.of(file) == FileIdentity{was.at("bytes"), was.at("xxh3")};
    if (!same) add_changed(file, out);
    for (const json& companion : was.value("companions", json::array()))
        compare(file_named(file.parent_path(), companion.at("name").get<std::string>()), companion,
                identities, out);
    for (const json& name : was.value("absent", json::array()))
        if (const fs::path added = file_named(file.parent_path(), name.get<std::string>()); fs::exists(added))
            add_new(added, out);
}

void compare_cameras(const json& meta, const fs::path& cameras, IdentityCache& identities, Changes& out) {
    const std::vector<fs::path> now = cameras.empty() ? std::vector<fs::path>() : camera_files(cameras);
    const fs::path folder = fs::is_directory(cameras) ? cameras : cameras.parent_path();
    std::set<std::string> known;
    for (const json& was : meta.at("inputs").at("cameras")) {
        const auto name = was.at("name").get<std::string>();
        const auto file = std::ranges::find_if(now, [&](const fs::path& f) {
            return comparable_name(name_below(folder, f)) == comparable_name(name);
        });
        compare(file == now.end() ? folder / name : *file, was, identities, out);
        known.insert(comparable_name(name));
    }
    // A new file may have a format that takes precedence, or be an optional file of the same format.
    for (const fs::path& file : now)
        if (!known.contains(comparable_name(name_below(folder, file)))) add_new(file, out);
}

/// Compares the camera files of image sets, by their paths in the photos' folder, and the file that names the
/// image sets.
void compare_image_sets(const json& meta, const InputFiles& files, IdentityCache& identities, Changes& out) {
    const json& inputs = meta.at("inputs");
    std::set<fs::path> known;
    for (const json& was : inputs.value("more_cameras", json::array())) {
        const fs::path file = file_named(files.photos, was.at("name").get<std::string>());
        compare(file, was, identities, out);
        known.insert(file);
    }
    for (const fs::path& more : files.more_cameras)
        for (const fs::path& file : camera_files(more))
            if (!known.contains(file)) add_new(file, out);
    if (!is_image_sets_file(files.image_sets)) return;
    if (inputs.contains("image_sets"))
        compare(files.image_sets, inputs.at("image_sets"), identities, out);
    else
        add_new(files.image_sets, out);
}

/// Compares the files in a list of META's inputs. Of several files with the same name, at least one must be
/// unchanged.
void compare_listed(const json& meta, const char* list, const std::vector<fs::path>& files,
                    IdentityCache& identities, Changes& out) {
    for (const json& was : meta.at("inputs").value(list, json::array())) {
        Changes changes;
        std::size_t named = 0, changed = 0;
        for (const fs::path& file : files) {
            if (utf8_name(file.filename().string()) != was.at("name").get<std::string>()) continue;
            const std::size_t before = changes.size();
            compare(file, was, identities, changes);
            ++named, changed += changes.size() > before;
        }
        if (named > 0 && changed == named) out.push_back(changes.front());
    }
}

/// Compares the mesh. A point-only scene has no mesh; a mesh may have been replaced with a cloud, or a cloud
/// with a mesh.
void compare_mesh(const json& meta, const fs::path& mesh, IdentityCache& identities, Changes& out) {
    const json was = meta.at("inputs").value("mesh", json{});
    if (was.is_object() && mesh.empty())
        add_missing(was.at("name").get<std::string>(), out);
    else if (was.is_object())
        compare(mesh, was, identities, out);
    else if (!mesh.empty())
        add_new(mesh, out);
}

/// In a point-only scene, all clouds must exist.
void compare_only_clouds(const json& meta, const std::vector<fs::path>& files, Changes& out) {
    if (meta.at("inputs").contains("mesh")) return;
    std::set<std::string> now, before;
    for (const fs::path& file : files) now.insert(utf8_name(file.filename().string()));
    for (const json& was : meta.at("inputs").value("points", json::array())) {
        before.insert(was.at("name").get<std::string>());
        if (!now.contains(was.at("name").get<std::string>()))
            add_missing(was.at("name").get<std::string>(), out);
    }
    for (const fs::path& file : files)
        if (!before.contains(utf8_name(file.filename().string()))) add_new(file, out);
}

/// Adds photos that the package neither contains nor lists as skipped.
void add_new_photos(const json& meta, const fs::path& folder, Changes& out) {
    std::set<fs::path> skipped;
    for (const json& l : meta.at("skipped"))
        skipped.insert(file_named(folder, l.at("name").get<std::string>()));
    std::vector<fs::path> used;
    for (const json& file : meta.at("inputs").at("photos"))
        used.push_back(file_named(folder, file.get<std::string>()));
    for (const fs::path& photo : unused_photos(folder, photos_below(folder), used))
        if (!skipped.contains(photo)) add_new(photo, out);
}

void compare_photos(const PackageReader& package, const json& meta, const fs::path& folder,
                    IdentityCache& identities, Changes& out) {
    const auto photos = package.photos();
    const json& files = meta.at("inputs").at("photos");
    for (std::size_t i = 0; i < photos.size() && i < files.size(); ++i) {
        if (photos[i].flags & package::photo_held_out) continue;
        const json was{{"bytes", photos[i].source_bytes}, {"xxh3", photos[i].source_checksum}};
        compare(file_named(folder, files[i].get<std::string>()), was, identities, out);
    }
}

void compare_masks(const PackageReader& package, const json& meta, const fs::path& folder,
                   IdentityCache& identities, Changes& out) {
    const auto photos = package.photos();
    const json& files = meta.at("inputs").at("photos");
    const json masks = meta.at("inputs").value("masks", json::object());
    Masks found;
    for (std::size_t i = 0; i < photos.size() && i < files.size(); ++i) {
        const fs::path mask = found.of(file_named(folder, files[i].get<std::string>()));
        const json was = masks.value(photos[i].name, json{});
        if (was.is_object() && mask.empty())
            add_missing(was.at("name").get<std::string>(), out);
        else if (was.is_object())
            compare(mask, was, identities, out);
        else if (!mask.empty())
            add_new(mask, out);
    }
}

/// Compares skipped photos: their files may have appeared, changed or disappeared. For a photo without a
/// camera, only its existence matters.
void compare_skipped(const json& meta, const fs::path& folder, IdentityCache& identities, Changes& out) {
    for (const json& l : meta.at("skipped")) {
        const fs::path photo = file_named(folder, l.at("name").get<std::string>());
        const bool exists = fs::exists(photo);
        if (exists != l.at("there").get<bool>()) {
            if (exists)
                add_new(photo, out);
            else
                add_missing(photo.string(), out);
        } else if (exists && l.at("why") != without_camera) {
            const std::optional<FileIdentity> now = identities.try_of(photo);
            const auto was =
                l.contains("bytes") ? std::optional(FileIdentity{l["bytes"], l["xxh3"]}) : std::nullopt;
            if (now != was) add_changed(photo, out);
        }
    }
}

/// The changes to an input that has no photos, or no longer has any.
Changes without_photos(const PackageReader& package, Changes out) {
    for (const package::PhotoRecord& p : package.photos()) add_missing(p.name, out);
    return out;
}

}  // namespace

Changes changed_inputs(const PackageReader& package, const InputFiles& files, IdentityCache& identities) {
    const json meta = parse_meta(package);
    try {
        Changes out;
        compare_mesh(meta, files.mesh, identities, out);
        // Packages of earlier versions list the materials of an OBJ here.
        for (const json& was : meta.at("inputs").value("materials", json::array()))
            compare(file_named(files.mesh.parent_path(), was.at("name").get<std::string>()), was, identities,
                    out);
        compare_listed(meta, "compared", files.compared, identities, out);
        compare_listed(meta, "points", files.points, identities, out);
        compare_only_clouds(meta, files.points, out);
        compare_cameras(meta, files.cameras, identities, out);
        compare_image_sets(meta, files, identities, out);
        if (files.photos.empty()) return without_photos(package, std::move(out));
        compare_photos(package, meta, files.photos, identities, out);
        compare_masks(package, meta, files.photos, identities, out);
        compare_skipped(meta, files.photos, identities, out);
        add_new_photos(meta, files.photos, out);
        return out;
    } catch (const json::exception& e) {
        throw Error(Exit::damaged, package.path().string() + ": META: " + e.what());
    }
}

std::vector<std::string> names_listed(const PackageReader& package, const char* list) {
    std::vector<std::string> out;
    const json meta = parse_meta(package);
    try {
        for (const json& was : meta.at("inputs").value(list, json::array()))
            if (was.at("name") != meta.at("inputs").value("mesh", json::object()).value("name", ""))
                out.push_back(was.at("name").get<std::string>());
    } catch (const json::exception& e) {
        throw Error(Exit::damaged, package.path().string() + ": META: " + e.what());
    }
    return out;
}

std::string image_sets_wanted(const PackageReader& package) {
    const json meta = parse_meta(package);
    const json config = meta.value("config", json::object());
    const json wanted = config.value("image_sets", json(image_sets_auto));
    return wanted.is_string() ? wanted.get<std::string>() : image_sets_auto;
}

std::vector<std::string> changed_settings(const PackageReader& package, const PrepareSettings& settings) {
    const json meta = parse_meta(package), now = settings_json(settings);
    std::vector<std::string> out;
    if (const json was = meta.value("tool", json{}); was != tool_name)
        out.push_back("prepared by " + json_text(was, -1) + ", this is " + tool_name);
    // Versions up to 0.6.1 warned of a color profile that they did not convert.
    for (const json& warning : meta.value("warnings", json::array()))
        if (warning.is_string() && warning.get<std::string>().ends_with("', treated as sRGB"))
            out.push_back(warning.get<std::string>());
    const json was = meta.value("config", json::object());
    for (const auto& [key, value] : now.items())
        if (const json before = was.value(key, json{}); before != value)
            out.push_back("setting " + key + ": was " + json_text(before, -1) + ", is now " +
                          json_text(value, -1));
    for (const char* const key : {"image_sets", "convention", "align"})  // stored only if not the default
        if (was.contains(key) && !now.contains(key))
            out.push_back(std::string("setting ") + key + ": was " + json_text(was.at(key), -1) +
                          ", is no longer given");
    return out;
}

std::string damage_of(const PackageReader& package, IdentityCache& identities) {
    const std::string stamp = stamp_of(package.path());
    if (identities.known_valid(stamp)) return {};
    const std::vector<Mismatch> found = mismatches(package, true, 1);
    if (found.empty()) identities.remember_valid(package.path(), stamp);
    return found.empty() ? std::string() : found.front().text;
}

std::vector<UnusablePhoto> skipped_of(const PackageReader& package) {
    std::vector<UnusablePhoto> out;
    const json meta = parse_meta(package);
    for (const json& l : meta.value("skipped", json::array()))
        out.push_back({l.value("name", ""), l.value("why", "")});
    const auto photos = package.photos();
    const auto states = package.records<package::PhotoState>(package::Type::states);
    for (std::size_t i = 0; i < photos.size() && i < states.size(); ++i)
        if (photos[i].flags & package::photo_skipped)
            out.push_back({photos[i].name,
                           {states[i].skipped, ::strnlen(states[i].skipped, sizeof states[i].skipped)}});
    std::ranges::sort(out, {}, &UnusablePhoto::photo);
    return out;
}

}  // namespace vantage
