#include "pipeline/package/staleness.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "pipeline/input/discover.h"
#include "pipeline/package/meta.h"
#include "scene/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Lines = std::vector<std::string>;

/// "" if the file is unchanged.
std::string change_of(const fs::path& file, const json& was, IdentityCache& identities) {
    if (!fs::exists(file)) return file.string() + ": is gone";
    const bool same = fs::file_size(file) == was.at("bytes").get<std::uint64_t>() &&
                      identities.of(file) == FileIdentity{was.at("bytes"), was.at("xxh3")};
    return same ? "" : file.string() + ": has changed since the package was prepared";
}

Lines changed_cameras(const json& meta, const fs::path& cameras, IdentityCache& identities) {
    Lines out;
    const auto now = camera_files(cameras);
    for (const json& was : meta.at("inputs").at("cameras")) {
        const auto name = was.at("name").get<std::string>();
        const auto file =
            std::ranges::find(now, name, [](const fs::path& f) { return f.filename().string(); });
        out.push_back(change_of(file == now.end() ? cameras / name : *file, was, identities));
    }
    return out;
}

/// Photos in the folder that the package does not know.
Lines new_photos(const PackageReader& package, const json& meta, const fs::path& folder) {
    std::set<std::string> known;
    for (const package::PhotoRecord& p : package.photos()) known.insert(p.name);
    for (const json& l : meta.at("left_out")) known.insert(l.at("name").get<std::string>());
    Lines found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_photo(entry.path()) && !known.contains(entry.path().filename().string()))
            found.push_back(entry.path().string() + ": is new since the package was prepared");
    std::ranges::sort(found);
    return found;
}

Lines changed_photos(const PackageReader& package, const json& meta, const fs::path& folder,
                     IdentityCache& identities) {
    Lines out;
    const auto photos = package.photos();
    const json& files = meta.at("inputs").at("photos");
    for (std::size_t i = 0; i < photos.size() && i < files.size(); ++i) {
        if (photos[i].flags & package::photo_held_out) continue;
        const json was{{"bytes", photos[i].source_bytes}, {"xxh3", photos[i].source_checksum}};
        out.push_back(change_of(folder / files[i].get<std::string>(), was, identities));
    }
    return out;
}

Lines changed_stencils(const PackageReader& package, const json& meta, const fs::path& folder,
                       IdentityCache& identities) {
    Lines out;
    const auto photos = package.photos();
    const json& files = meta.at("inputs").at("photos");
    const json stencils = meta.at("inputs").value("stencils", json::object());
    for (std::size_t i = 0; i < photos.size() && i < files.size(); ++i) {
        const fs::path stencil = find_stencil(folder / files[i].get<std::string>());
        const json was = stencils.value(photos[i].name, json{});
        if (was.is_object())
            out.push_back(stencil.empty() ? was.at("name").get<std::string>() + ": is gone"
                                          : change_of(stencil, was, identities));
        else if (!stencil.empty())
            out.push_back(stencil.string() + ": is new since the package was prepared");
    }
    return out;
}

Lines changed_left_out(const json& meta, const fs::path& folder) {
    Lines out;
    for (const json& l : meta.at("left_out")) {
        const fs::path photo = folder / l.at("name").get<std::string>();
        if (const bool there = fs::exists(photo); there != l.at("there").get<bool>())
            out.push_back(photo.string() + (there ? ": is there now" : ": is gone"));
    }
    return out;
}

}  // namespace

Lines changed_inputs(const PackageReader& package, const InputFiles& files, IdentityCache& identities) {
    const json meta = parse_meta(package);
    try {
        Lines out{change_of(files.mesh, meta.at("inputs").at("mesh"), identities)};
        for (const Lines& lines :
             {changed_cameras(meta, files.cameras, identities),
              changed_photos(package, meta, files.photos, identities),
              changed_stencils(package, meta, files.photos, identities), changed_left_out(meta, files.photos),
              new_photos(package, meta, files.photos)})
            out.insert(out.end(), lines.begin(), lines.end());
        std::erase(out, "");
        return out;
    } catch (const json::exception& e) {
        throw Error(Exit::damaged, package.path().string() + ": META: " + e.what());
    }
}

Lines changed_settings(const PackageReader& package, const PrepareSettings& settings) {
    const json meta = parse_meta(package), now = settings_json(settings);
    Lines out;
    if (const json was = meta.value("tool", json{}); was != tool_name)
        out.push_back("prepared by " + was.dump() + ", this is " + tool_name);
    const json was = meta.value("config", json::object());
    for (const auto& [key, value] : now.items())
        if (const json before = was.value(key, json{}); before != value)
            out.push_back("the setting " + key + " was " + before.dump() + ", is " + value.dump());
    return out;
}

std::vector<UnusablePhoto> left_out_of(const PackageReader& package) {
    std::vector<UnusablePhoto> out;
    const json meta = parse_meta(package);
    for (const json& l : meta.value("left_out", json::array()))
        out.push_back({l.value("name", ""), l.value("why", "")});
    const auto photos = package.photos();
    const auto states = package.records<package::PhotoState>(package::Type::states);
    for (std::size_t i = 0; i < photos.size() && i < states.size(); ++i)
        if (photos[i].flags & package::photo_left_out)
            out.push_back({photos[i].name,
                           {states[i].left_out, ::strnlen(states[i].left_out, sizeof states[i].left_out)}});
    std::ranges::sort(out, {}, &UnusablePhoto::photo);
    return out;
}

}  // namespace vantage
