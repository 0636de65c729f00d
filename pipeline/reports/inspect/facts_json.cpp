#include "pipeline/reports/inspect/facts_json.h"

#include <nlohmann/json.hpp>

#include "base/text/file_name.h"
#include "pipeline/output/disk_space.h"
#include "pipeline/reports/inspect/file_facts.h"

namespace vantage {
namespace {

using nlohmann::json;

/// The path as text; null if it is empty.
json json_of(const std::filesystem::path& path) {
    return path.empty() ? json() : json(utf8_name(path.string()));
}
json json_of(const std::vector<std::filesystem::path>& paths) {
    json out = json::array();
    for (const std::filesystem::path& path : paths) out.push_back(json_of(path));
    return out;
}
json json_of(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
json json_of(const Range& range) { return range.empty() ? json() : json{range.low, range.high}; }

json json_of(const ShapeFacts& shape, const std::vector<std::filesystem::path>& files) {
    return {
        {"format", format_of(files.front())}, {"bytes", length_of(files)}, {"vertices", shape.vertices},
        {"triangles", shape.triangles},       {"low", json_of(shape.low)}, {"high", json_of(shape.high)},
        {"far_away", shape.strays},           {"colors", shape.colors},    {"scalar_fields", shape.fields}};
}

json mesh_json(const InputFacts& facts) {
    if (!facts.mesh) return {};
    json out = json_of(*facts.mesh, {facts.files.mesh});
    out["file"] = json_of(facts.files.mesh);
    std::vector<std::filesystem::path> read = companions_of(facts.files.mesh, facts.files);
    std::erase_if(read, [](const std::filesystem::path& file) { return !std::filesystem::exists(file); });
    out["companions"] = json_of(read);
    return out;
}

json points_json(const InputFacts& facts) {
    if (!facts.points) return {};
    json out = json_of(*facts.points, facts.files.points);
    out["files"] = json_of(facts.files.points);
    return out;
}

json json_of(const LensFacts& lens) {
    json coefficients = json::object();
    for (const LensFacts::Coefficient& c : lens.coefficients) coefficients[c.name] = json_of(c.value);
    return {{"count", lens.cameras},
            {"calibrations", lens.calibrations},
            {"width", lens.width ? json(lens.width) : json()},
            {"height", lens.height ? json(lens.height) : json()},
            {"model", name(lens.model)},
            {"coefficients", coefficients},
            {"focal_unit", name(lens.unit)},
            {"focal_x", json_of(lens.focal_x)},
            {"focal_y", json_of(lens.focal_y)},
            {"field_of_view_x", json_of(lens.view_x)},
            {"field_of_view_y", json_of(lens.view_y)}};
}

json cameras_json(const InputFacts& facts) {
    if (!facts.cameras) return {};
    std::vector<std::filesystem::path> files{facts.files.cameras};
    files.insert(files.end(), facts.files.more_cameras.begin(), facts.files.more_cameras.end());
    const Eigen::AlignedBox3d& box = facts.cameras->centers;
    json lenses = json::array();
    for (const LensFacts& lens : facts.cameras->lenses) lenses.push_back(json_of(lens));
    return {{"files", json_of(files)},
            {"format", facts.camera_format},
            {"count", facts.cameras->cameras},
            {"low", box.isEmpty() ? json() : json_of(Eigen::Vector3d(box.min()))},
            {"high", box.isEmpty() ? json() : json_of(Eigen::Vector3d(box.max()))},
            {"lenses", lenses}};
}

json photos_json(const InputFacts& facts) {
    if (!facts.photos) return {};
    json groups = json::array();
    for (const PhotoGroup& group : facts.photos->groups)
        groups.push_back({{"format", group.format},
                          {"width", group.size.width ? json(group.size.width) : json()},
                          {"height", group.size.height ? json(group.size.height) : json()},
                          {"count", group.photos},
                          {"bytes", group.bytes}});
    return {{"folder", json_of(facts.files.photos)},
            {"count", facts.photos->photos()},
            {"megapixels", facts.photos->pixels() / 1e6},
            {"bytes", facts.photos->bytes()},
            {"groups", groups},
            {"masks", facts.photos->masks}};
}

json image_sets_json(const InputFacts& facts) {
    json out = json::array();
    if (facts.scene)
        for (const auto& image_set : facts.scene->image_sets)
            out.push_back({{"name", image_set.name}, {"count", image_set.photos}});
    return out;
}

json scale_json(const InputFacts& facts) {
    if (!facts.scene || !facts.scene->scale) return {};
    const ScaleFacts& scale = *facts.scene->scale;
    return {{"unit", nullptr},
            {"guessed_units", plausible_units(scale.typical)},
            {"distance", json_of(scale.distance)},
            {"typical_distance", scale.typical},
            {"typical_distance_in_diagonals", scale.in_model},
            {"typical_pixel", scale.pixel}};
}

json skipped_json(const InputFacts& facts) {
    json out = json::array();
    for (const UnusablePhoto& photo : facts.skipped)
        out.push_back({{"photo", photo.photo}, {"why", utf8_name(photo.why)}});
    return out;
}

json effects_json(const InputFacts& facts) {
    if (!facts.plan) return {};
    json out = json::array();
    for (const EffectDecision& d : facts.plan->effects) {
        const EffectRow& row = effect_row(d.effect);
        const bool open = from_all_photos(row);
        out.push_back({{"name", row.option},
                       {"on", open ? json() : json(d.on)},
                       {"measures", row.measures},
                       {"measured", open ? json() : json(d.measured)},
                       {"threshold", row.threshold},
                       {"unit", row.unit},
                       {"evidence", d.evidence}});
    }
    return out;
}

json needs_json(const InputFacts& facts) {
    if (!facts.plan) return {};
    const ResourceEstimate& needs = facts.plan->needs;
    return {{"seconds", needs.seconds},
            {"memory_bytes", needs.memory},
            {"photos_at_a_time", needs.in_flight},
            {"disk_bytes", needs.disk},
            {"disk_free_bytes", needs.disk_free == unknown_space ? json() : json(needs.disk_free)}};
}

json error_json(const InputFacts& facts) {
    if (!facts.error) return {};
    return {{"exit_code", int(facts.error->code())}, {"message", facts.error->what()}};
}

}  // namespace

json facts_json(const InputFacts& facts) {
    return {{"mesh", mesh_json(facts)},
            {"points", points_json(facts)},
            {"cameras", cameras_json(facts)},
            {"photos", photos_json(facts)},
            {"image_sets", image_sets_json(facts)},
            {"scale", scale_json(facts)},
            {"usable_photos", facts.scene ? json(facts.scene->photos) : json()},
            {"skipped", skipped_json(facts)},
            {"not_seeing", facts.plan ? json(facts.plan->not_seeing) : json()},
            {"effects", effects_json(facts)},
            {"needs", needs_json(facts)},
            {"notes", facts.files.notes},
            {"warnings", facts.warnings},
            {"error", error_json(facts)},
            {"exit_code", int(facts.exit())}};
}

}  // namespace vantage
