#include "pipeline/output/meta.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "base/text/json_text.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/image_set_groups.h"
#include "pipeline/input/photo_matches.h"

namespace vantage {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Judgment, photos, gain, error, noise, worst, worse, ssim, seams_before,
                                   seams_after, worst_photo)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Bytes of padding, reserved for later results.
constexpr std::size_t padding = 8192;
constexpr std::size_t max_findings = 8;

json input_json(const fs::path& file, IdentityCache& identities) {
    const FileIdentity id = identities.of(file);
    return {{"name", utf8_name(file.filename().string())}, {"bytes", id.bytes}, {"xxh3", id.checksum}};
}

/// A mesh and its companions, whose names are relative to its folder; missing ones are listed as `absent`.
json mesh_json(const fs::path& file, const InputFiles& files, IdentityCache& identities) {
    json out = input_json(file, identities);
    for (const fs::path& companion : companions_of(file, files)) {
        const std::string name = utf8_name(companion.lexically_relative(file.parent_path()).generic_string());
        if (!fs::exists(companion)) {
            out["absent"].push_back(name);
            continue;
        }
        json entry = input_json(companion, identities);
        entry["name"] = name;
        out["companions"].push_back(std::move(entry));
    }
    return out;
}

/// Includes the identity of the photo's file if it was read, so that a repaired photo is recognized.
json skipped_json(const UnusablePhoto& photo, const fs::path& folder, IdentityCache& identities) {
    const fs::path file = file_named(folder, photo.photo);
    json out{{"name", photo.photo}, {"why", utf8_name(photo.why)}, {"there", fs::exists(file)}};
    if (photo.file.empty()) return out;
    if (const auto id = identities.try_of(photo.file)) {
        out["bytes"] = id->bytes;
        out["xxh3"] = id->checksum;
    }
    return out;
}

json effect_json(const EffectDecision& d) {
    const EffectRow& row = effect_row(d.effect);
    json out{{"name", row.name},       {"on", d.on},
             {"forced", d.forced},     {"measures", row.measures},
             {"measured", d.measured}, {"threshold", row.threshold},
             {"unit", row.unit},       {"evidence", d.evidence}};
    if (d.judgment) out["judged"] = *d.judgment;
    for (const ImageSetDecision& b : d.image_sets) {
        json image_set{
            {"name", b.image_set}, {"on", b.on}, {"measured", b.measured}, {"evidence", b.evidence}};
        if (b.judgment) image_set["judged"] = *b.judgment;
        out["image_sets"].push_back(std::move(image_set));
    }
    return out;
}

json choices_json(const std::map<Effect, EffectChoice>& choices) {
    json forced = json::object();
    for (const auto& [effect, choice] : choices)
        if (choice != EffectChoice::automatic)
            forced[effect_row(effect).name] = choice == EffectChoice::on ? "on" : "off";
    return forced;
}

json inputs_json(const SceneInput& scene, IdentityCache& identities) {
    json inputs;
    if (!scene.files.mesh.empty()) inputs["mesh"] = mesh_json(scene.files.mesh, scene.files, identities);
    inputs["compared"] = json::array();
    for (const fs::path& file : scene.files.compared)
        inputs["compared"].push_back(mesh_json(file, scene.files, identities));
    inputs["points"] = json::array();
    for (const fs::path& file : scene.files.points) inputs["points"].push_back(input_json(file, identities));
    inputs["camera_format"] = scene.camera_format;
    inputs["convention"] = scene.convention;
    if (scene.files.cameras.empty())
        inputs["cameras"] = json::array();
    else
        for (const fs::path& file : camera_files(scene.files.cameras)) {
            const fs::path& cameras = scene.files.cameras;
            json entry = input_json(file, identities);
            entry["name"] = name_below(fs::is_directory(cameras) ? cameras : cameras.parent_path(), file);
            inputs["cameras"].push_back(std::move(entry));
        }
    // These files are listed by path, because their names may be equal.
    for (const fs::path& more : scene.files.more_cameras)
        for (const fs::path& file : camera_files(more)) {
            json entry = input_json(file, identities);
            entry["name"] = utf8_name(file.lexically_relative(scene.files.photos).generic_string());
            inputs["more_cameras"].push_back(std::move(entry));
        }
    if (is_image_sets_file(scene.files.image_sets))
        inputs["image_sets"] = input_json(scene.files.image_sets, identities);
    if (scene.photos.empty()) inputs["photos"] = json::array();
    for (const PhotoInput& photo : scene.photos)
        inputs["photos"].push_back(
            utf8_name(photo.file.lexically_relative(scene.files.photos).generic_string()));
    inputs["masks"] = json::object();
    for (const PhotoInput& photo : scene.photos)
        if (!photo.mask.empty()) inputs["masks"][photo.name] = input_json(photo.mask, identities);
    return inputs;
}

json findings_json(std::span<const std::string> findings, std::size_t listed) {
    json out = json::array();
    for (const std::string& finding : findings.first(listed)) out.push_back(finding);
    if (listed < findings.size()) out.push_back("and " + std::to_string(findings.size() - listed) + " more");
    return out;
}

/// META padded to `bytes`. If the text is longer, findings and evidence are dropped: neither is needed to
/// render the package.
std::string fitted(json meta, std::size_t bytes) {
    std::string out = json_text(meta);
    if (out.size() > bytes) {
        meta.erase("findings");
        for (json& row : meta.at("effects")) {
            row["evidence"] = "too long to be recorded";
            row.erase("image_sets");
        }
        out = json_text(meta);
    }
    out.resize(bytes, ' ');
    return out;
}

std::string file_name(const fs::path& file) { return utf8_name(file.filename().string()); }

json names_of(const std::vector<std::string>& files) {
    json out = json::array();
    for (const std::string& file : files) out.push_back(file_name(file));
    return out;
}

}  // namespace

json settings_json(const PrepareSettings& s) {
    json out{{"distance", name(s.distance)},
             {"render_by", name(s.render_by)},
             {"thumbnail", s.thumbnail},
             {"photo_size", s.photo_size},
             {"hold_out", s.hold_out},
             {"validate", s.validate},
             {"deviation_from", names_of(s.deviation_from)},
             {"points", names_of(s.points)},
             {"effects", choices_json(s.effects)}};
    if (s.image_sets != image_sets_auto)
        out["image_sets"] = is_image_sets_file(s.image_sets) ? file_name(s.image_sets) : s.image_sets;
    if (s.convention != "auto") out["convention"] = s.convention;
    if (s.align) {
        const auto m = matrix_of(*s.align);
        for (const auto& row : m.rowwise()) out["align"].push_back({row[0], row[1], row[2], row[3]});
    }
    if (s.vertex_coordinates) out["vertex_coordinates"] = true;
    return out;
}

std::string make_meta(const SceneInput& scene, const PrepareSettings& settings,
                      const std::vector<EffectDecision>& effects, IdentityCache& identities) {
    json meta{{"tool", tool_name}, {"config", settings_json(settings)}};
    meta["inputs"] = inputs_json(scene, identities);
    // In scenes that do not need one of these effects, META is the same as before the effect was introduced.
    const auto called_for = [](const EffectDecision& d) {
        const bool seldom = d.effect == Effect::transparency || d.effect == Effect::compact;
        return !seldom || d.forced || d.measured > 0;
    };
    for (const EffectDecision& d : effects)
        if (called_for(d)) meta["effects"].push_back(effect_json(d));
    meta["scalars"] = json::array();
    if (std::ranges::any_of(
            effects, [](const EffectDecision& d) { return d.effect == Effect::scalar_fields && d.on; }))
        for (const VertexField& field : scene.mesh.scalars) meta["scalars"].push_back(utf8_name(field.name));
    meta["skipped"] = json::array();
    for (const UnusablePhoto& l : scene.skipped)
        meta["skipped"].push_back(skipped_json(l, scene.files.photos, identities));
    // The identities must be those of the bytes that were read earlier.
    for (const StampedFile& file : scene.read) expect_unchanged(file);
    meta["warnings"] = json::array();
    for (const std::string& w : scene.warnings) meta["warnings"].push_back(utf8_name(w));
    return json_text(meta) + std::string(padding * scene.image_sets.size(), ' ');
}

std::string with_results(const std::string& meta, std::span<const EffectDecision> decisions,
                         std::span<const std::string> findings) {
    json changed = json_of(meta);
    for (json& row : changed.at("effects"))
        for (const EffectDecision& d : decisions)
            if (row.at("name") == effect_row(d.effect).name) row = effect_json(d);
    std::size_t listed = std::min(findings.size(), max_findings);
    changed["findings"] = findings_json(findings, listed);
    while (listed > 0 && json_text(changed).size() > meta.size())
        changed["findings"] = findings_json(findings, --listed);
    return fitted(changed, meta.size());
}

std::string repacked_meta(const std::string& meta, bool compact) {
    json changed = json_of(meta);
    const char* name = effect_row(Effect::compact).name;
    changed.at("config").at("effects")[name] = compact ? "on" : "off";
    for (json& row : changed.at("effects")) {
        if (row.at("name") != name) continue;
        row["on"] = compact;
        row["forced"] = true;
        return json_text(changed);
    }
    changed.at("effects").push_back(effect_json(
        decide(Effect::compact, compact ? EffectChoice::on : EffectChoice::off, 0, "not measured")));
    return json_text(changed);
}

std::string with_choices(const std::string& meta, const std::map<Effect, EffectChoice>& choices) {
    json changed = json_of(meta);
    changed.at("config").at("effects") = choices_json(choices);
    return fitted(changed, meta.size());
}

json parse_meta(const PackageReader& package) {
    json meta = json_of(package.meta());
    if (!meta.is_object()) throw Error(Exit::damaged, package.path().string() + ": META: cannot be parsed");
    return meta;
}

EffectDecision decision_in(const std::string& meta, Effect effect) {
    EffectDecision d{};
    d.effect = effect;
    const json all = json_of(meta);
    for (const json& row : all.at("effects"))
        if (row.at("name") == effect_row(effect).name) {
            d.on = row.at("on");
            d.forced = row.at("forced");
            d.measured = row.at("measured");
            d.evidence = row.at("evidence");
            if (row.contains("judged")) d.judgment = row.at("judged").get<Judgment>();
            for (const json& b : row.value("image_sets", json::array())) {
                d.image_sets.push_back({b.at("name"), b.at("on"), b.at("measured"), b.at("evidence")});
                if (b.contains("judged")) d.image_sets.back().judgment = b.at("judged").get<Judgment>();
            }
        }
    return d;
}

std::vector<std::string> findings_in(const std::string& meta) {
    return json_of(meta).value("findings", std::vector<std::string>{});
}

std::map<Effect, EffectChoice> choices_in(const std::string& meta) {
    std::map<Effect, EffectChoice> out;
    const json forced = json_of(meta).at("config").at("effects");
    for (const auto& [name, choice] : forced.items())
        out[effect_row(name).effect] = choice == "on" ? EffectChoice::on : EffectChoice::off;
    return out;
}

PrepareSettings scene_settings_in(const std::string& meta) {
    const json config = json_of(meta).at("config");
    PrepareSettings s;
    s.distance = distance_method(config.at("distance"));
    s.render_by = render_by(config.at("render_by"));
    s.validate = config.value("validate", true);
    s.vertex_coordinates = config.value("vertex_coordinates", false);
    return s;
}

}  // namespace vantage
