#include "pipeline/provenance.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "pipeline/import/discover.h"
#include "scene/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* tool = "vantage " VANTAGE_VERSION;
/// Bytes of META for what is found out last.
constexpr std::size_t room = 8192;
/// Lines of findings; each names two photos at most, whose names have 191 bytes at most.
constexpr std::size_t most_findings = 8;

json input_json(const fs::path& file, IdentityCache& identities) {
    const FileIdentity id = identities.of(file);
    return {{"name", file.filename().string()}, {"bytes", id.bytes}, {"xxh3", id.checksum}};
}

json effect_json(const EffectDecision& d) {
    const EffectRow& row = effect_row(d.effect);
    return {{"name", row.name},       {"on", d.on},
            {"forced", d.forced},     {"measures", row.measures},
            {"measured", d.measured}, {"threshold", row.threshold},
            {"unit", row.unit},       {"evidence", d.evidence}};
}

json read_meta(const PackageReader& package) {
    try {
        return json::parse(package.meta());
    } catch (const json::exception& e) {
        throw Error(Exit::damaged, package.path().string() + ": META: not readable: " + e.what());
    }
}

/// "" where the file is as it was.
std::string change_of(const fs::path& file, const json& was, IdentityCache& identities) {
    if (!fs::exists(file)) return file.string() + ": is gone";
    const bool same = fs::file_size(file) == was.at("bytes").get<std::uint64_t>() &&
                      identities.of(file) == FileIdentity{was.at("bytes"), was.at("xxh3")};
    return same ? "" : file.string() + ": has changed since the package was prepared";
}

/// Photos of the folder that the package knows nothing of.
std::vector<std::string> new_photos(const PackageReader& package, const json& meta, const fs::path& folder) {
    std::set<std::string> seen;
    for (const package::PhotoRecord& p : package.photos()) seen.insert(p.name);
    for (const json& l : meta.at("left_out")) seen.insert(l.at("name").get<std::string>());
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_photo(entry.path()) && !seen.contains(entry.path().filename().string()))
            found.push_back(entry.path().string() + ": is new since the package was prepared");
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> changed_photos(const PackageReader& package, const json& meta,
                                        const fs::path& folder, IdentityCache& identities) {
    std::vector<std::string> out;
    const auto photos = package.photos();
    const json& files = meta.at("inputs").at("photos");
    for (std::size_t i = 0; i < photos.size() && i < files.size(); ++i) {
        if (photos[i].flags & package::photo_held_out) continue;
        const json was{{"bytes", photos[i].source_bytes}, {"xxh3", photos[i].source_checksum}};
        out.push_back(change_of(folder / files[i].get<std::string>(), was, identities));
    }
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
    for (const json& l : meta.at("left_out"))
        if (const bool there = fs::exists(folder / l.at("name").get<std::string>());
            there != l.at("there").get<bool>())
            out.push_back((folder / l.at("name").get<std::string>()).string() +
                          (there ? ": is there now" : ": is gone"));
    std::erase(out, "");
    return out;
}

}  // namespace

namespace {

json forced_json(const std::map<Effect, EffectChoice>& choices) {
    json forced = json::object();
    for (const auto& [effect, choice] : choices)
        if (choice != EffectChoice::automatic)
            forced[effect_row(effect).name] = choice == EffectChoice::on ? "on" : "off";
    return forced;
}

std::string fitted(const json& meta, std::size_t bytes) {
    std::string out = meta.dump(1);
    if (out.size() > bytes) throw std::logic_error("META has too little room for its effects");
    out.resize(bytes, ' ');
    return out;
}

}  // namespace

json settings_json(const PrepareSettings& s) {
    return {{"distance", name(s.distance)},
            {"render_by", name(s.render_by)},
            {"border_width", s.border_width},
            {"border_threshold", s.border_threshold},
            {"thumbnail", s.thumbnail},
            {"resampling", name(s.resampling)},
            {"cluster_triangles", s.cluster_triangles},
            {"photo_size", s.photo_size},
            {"hold_out", s.hold_out},
            {"effects", forced_json(s.effects)}};
}

std::string provenance(const SceneInput& scene, const PrepareSettings& settings,
                       const std::vector<EffectDecision>& effects, IdentityCache& identities) {
    json meta{{"tool", tool}, {"config", settings_json(settings)}};
    json& inputs = meta["inputs"];
    inputs["mesh"] = input_json(scene.files.mesh, identities);
    inputs["camera_format"] = scene.camera_format;
    for (const fs::path& file : camera_files(scene.files.cameras))
        inputs["cameras"].push_back(input_json(file, identities));
    for (const PhotoInput& photo : scene.photos)
        inputs["photos"].push_back(photo.file.lexically_relative(scene.files.photos).generic_string());
    inputs["stencils"] = json::object();
    for (const PhotoInput& photo : scene.photos)
        if (!photo.stencil.empty()) inputs["stencils"][photo.name] = input_json(photo.stencil, identities);
    for (const EffectDecision& d : effects) meta["effects"].push_back(effect_json(d));
    meta["scalars"] = json::array();
    for (const ScalarLayer& layer : scene.mesh.scalars) meta["scalars"].push_back(layer.name);
    meta["left_out"] = json::array();
    for (const UnusablePhoto& l : scene.left_out)
        meta["left_out"].push_back(
            {{"name", l.photo}, {"why", l.why}, {"there", fs::exists(scene.files.photos / l.photo)}});
    meta["warnings"] = scene.warnings;
    return meta.dump(1) + std::string(room, ' ');
}

std::string with_findings(const std::string& meta, std::span<const EffectDecision> decisions,
                          std::span<const std::string> findings) {
    json changed = json::parse(meta);
    const std::size_t shown = std::min(findings.size(), most_findings);
    changed["findings"] =
        std::vector<std::string>(findings.begin(), findings.begin() + std::ptrdiff_t(shown));
    if (shown < findings.size())
        changed["findings"].push_back("and " + std::to_string(findings.size() - shown) + " more");
    for (json& row : changed.at("effects"))
        for (const EffectDecision& d : decisions)
            if (row.at("name") == effect_row(d.effect).name) row = effect_json(d);
    return fitted(changed, meta.size());
}

EffectDecision decision_of(const std::string& meta, Effect effect) {
    EffectDecision d{};
    d.effect = effect;
    const json all = json::parse(meta);
    for (const json& row : all.at("effects"))
        if (row.at("name") == effect_row(effect).name) {
            d.on = row.at("on");
            d.forced = row.at("forced");
            d.measured = row.at("measured");
            d.evidence = row.at("evidence");
        }
    return d;
}

std::vector<std::string> findings_of(const std::string& meta) {
    return json::parse(meta).value("findings", std::vector<std::string>{});
}

std::string with_forced(const std::string& meta, const std::map<Effect, EffectChoice>& choices) {
    json changed = json::parse(meta);
    changed.at("config").at("effects") = forced_json(choices);
    return fitted(changed, meta.size());
}

std::map<Effect, EffectChoice> forced_effects(const std::string& meta) {
    std::map<Effect, EffectChoice> out;
    const json forced = json::parse(meta).at("config").at("effects");
    for (const auto& [name, choice] : forced.items())
        out[effect_row(name).effect] = choice == "on" ? EffectChoice::on : EffectChoice::off;
    return out;
}

PrepareSettings geometry_settings(const std::string& meta) {
    const json config = json::parse(meta).at("config");
    PrepareSettings s;
    s.distance = distance_method(config.at("distance"));
    s.render_by = render_by(config.at("render_by"));
    s.border_width = config.at("border_width");
    s.border_threshold = config.at("border_threshold");
    return s;
}

std::vector<std::string> changed_inputs(const PackageReader& package, const InputFiles& files,
                                        IdentityCache& identities) {
    const json meta = read_meta(package);
    try {
        std::vector<std::string> out{change_of(files.mesh, meta.at("inputs").at("mesh"), identities)};
        const auto now = camera_files(files.cameras);
        for (const json& was : meta.at("inputs").at("cameras")) {
            const auto file = std::ranges::find(now, was.at("name").get<std::string>(),
                                                [](const fs::path& f) { return f.filename().string(); });
            out.push_back(
                change_of(file == now.end() ? files.cameras / was.at("name").get<std::string>() : *file, was,
                          identities));
        }
        for (const auto& list : {changed_photos(package, meta, files.photos, identities),
                                 new_photos(package, meta, files.photos)})
            out.insert(out.end(), list.begin(), list.end());
        std::erase(out, "");
        return out;
    } catch (const json::exception& e) {
        throw Error(Exit::damaged, package.path().string() + ": META: " + e.what());
    }
}

std::vector<std::string> changed_settings(const PackageReader& package, const PrepareSettings& settings) {
    const json meta = read_meta(package), now = settings_json(settings);
    std::vector<std::string> out;
    if (const json was = meta.value("tool", json{}); was != tool)
        out.push_back("prepared by " + was.dump() + ", this is " + tool);
    const json was = meta.value("config", json::object());
    for (const auto& [key, value] : now.items())
        if (const json before = was.value(key, json{}); before != value)
            out.push_back("the setting " + key + " was " + before.dump() + ", is " + value.dump());
    return out;
}

std::vector<UnusablePhoto> left_out_of(const PackageReader& package) {
    std::vector<UnusablePhoto> out;
    const json meta = read_meta(package);
    for (const json& l : meta.value("left_out", json::array()))
        out.push_back({l.value("name", ""), l.value("why", "")});
    const auto photos = package.photos();
    const auto states = package.records<package::PhotoState>(package::Type::states);
    for (std::size_t i = 0; i < photos.size() && i < states.size(); ++i)
        if (photos[i].flags & package::photo_left_out)
            out.push_back({photos[i].name, {states[i].left_out, ::strnlen(states[i].left_out, 192)}});
    std::ranges::sort(out, {}, &UnusablePhoto::photo);
    return out;
}

}  // namespace vantage
