#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "pipeline/commands/commands.h"
#include "pipeline/costs/effect_costs.h"
#include "pipeline/costs/known_costs.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/pose_refinement_reuse.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/contents/point_cloud.h"
#include "scene/package/package_reader.h"
#include "scene/remote/remote_package.h"

namespace vantage {
namespace {

nlohmann::json describe_package(const PackageReader& reader) {
    nlohmann::json out = parse_meta(reader);
    const package::SceneRecord& s = reader.scene();
    out["bytes"] = reader.size();
    out["vertices"] = s.vertices;
    out["triangles"] = s.triangles;
    out["clusters"] = s.clusters;
    if (points_only(s)) {
        for (const char* of_mesh : {"vertices", "triangles", "clusters"}) out.erase(of_mesh);
        out["points"] = read_point_cloud(reader)->points;
        out["photos"] = nlohmann::json::array();
    }
    out["origin"] = s.origin;
    const Eigen::Vector3d up = up_of(s);
    out["up"] = {up.x(), up.y(), up.z()};
    if (s.first_photo < reader.photos().size()) out["first_photo"] = reader.photos()[s.first_photo].name;
    const std::vector<ImageSet> image_sets = read_image_sets(reader);
    for (const ImageSet& image_set : image_sets)
        if (image_sets.size() > 1) out["image_sets"].push_back(image_set.name);
    for (const package::PhotoRecord& p : reader.photos())
        out["photos"].push_back({{"name", p.name},
                                 {"width", p.width},
                                 {"height", p.height},
                                 {"held_out", bool(p.flags & package::photo_held_out)},
                                 {"registered", bool(p.flags & package::photo_registered)},
                                 {"focal", {p.fx, p.fy}},
                                 {"visible_vertices", p.visible_vertices},
                                 {"gain", p.gain},
                                 {"vignetting", p.vignetting},
                                 {"hull_area", p.hull_area},
                                 {"depth", {p.z_min, p.z_max}}});
    for (std::uint32_t i = 0; i < reader.photos().size(); ++i)
        if (const Lens lens = lens_of(reader, i); lens.distorts())
            out["photos"][i]["lens"] = name(lens.model);
    for (std::size_t i = 0; image_sets.size() > 1 && i < reader.photos().size(); ++i)
        out["photos"][i]["image_set"] = image_sets[reader.photos()[i].image_set].name;
    for (const package::PairRecord& p : pairs_of(reader))
        out["pairs"].push_back({{"photos", {reader.photos()[p.a].name, reader.photos()[p.b].name}},
                                {"corners", p.corners},
                                {"found", p.matches},
                                {"median_px", p.median},
                                {"p90_px", p.p90},
                                {"shift_px", p.shift},
                                {"angle", p.angle},
                                {"ln_color_ratio", p.color}});
    return out;
}

void print_package(const nlohmann::json& j, std::span<const EffectCost> costs, const KnownCosts& known) {
    const auto count = [&](const char* key) { return j[key].get<std::uint64_t>(); };
    const std::string shape =
        j.contains("points") ? fmt::format("{} point{}", count("points"), count("points") == 1 ? "" : "s")
                             : fmt::format("{} vertices, {} triangles in {} clusters", count("vertices"),
                                           count("triangles"), count("clusters"));
    fmt::print(
        text_output(), "{}\n{}, {} photos, {:.1f} MB\nup is {:.3g}{}\n\neffects\n",
        j["tool"].get<std::string>(), shape, j["photos"].size(), double(count("bytes")) / 1e6,
        fmt::join(j["up"].get<std::vector<double>>(), " "),
        j.contains("first_photo") ? "; opens at the camera of " + j["first_photo"].get<std::string>() : "");
    for (const auto& e : j["effects"])
        fmt::print(text_output(), "  {:<18} {:<4}{} {}\n", e["name"].get<std::string>(),
                   e["on"].get<bool>() ? "on" : "off", e["forced"].get<bool>() ? "(forced)" : "",
                   e["evidence"].get<std::string>());
    fmt::print(text_output(), "\n");
    for (const std::string& line : effect_lines(costs, known)) fmt::print(text_output(), "  {}\n", line);
    fmt::print(text_output(), "\nphotos\n");
    for (const auto& p : j["photos"])
        fmt::print(text_output(), "  {:<24} {}{}x{}  sees {:.1f} % of the {}{}\n",
                   p["name"].get<std::string>(),
                   p.contains("image_set") ? p["image_set"].get<std::string>() + ", " : "",
                   p["width"].get<int>(), p["height"].get<int>(), 100 * p["visible_vertices"].get<double>(),
                   j.contains("points") ? "points" : "vertices",
                   p["held_out"].get<bool>()     ? ", held out"
                   : p["registered"].get<bool>() ? ", camera registered"
                                                 : "");
    for (const char* kind : {"warnings", "findings"})
        for (const auto& w : j.value(kind, nlohmann::json::array()))
            fmt::print(text_output(), "warning  {}\n", w.get<std::string>());
}

/// Adds the effect's row of the table to its JSON object.
void add_costs_of(const EffectCost& cost, nlohmann::json& effect) {
    effect["package_bytes"] = cost.bytes;
    if (cost.gain) effect["gain_db"] = {{"mean", cost.gain->mean}, {"error", cost.gain->error}};
    if (cost.seams) effect["seams_change"] = *cost.seams;
    if (cost.seconds) effect["prepare_seconds"] = *cost.seconds;
    if (cost.frame_ms) effect["frame_ms"] = *cost.frame_ms;
}

}  // namespace

void add_info(const Command& program) {
    auto file = std::make_shared<std::string>();
    const Command c =
        program.verb("info", "Show the contents of a package, and its effects with their evidence");
    c.notes(
        "Examples:\n  vantage info --json chapel.vantage\n  vantage info "
        "https://example.org/scans/chapel.vantage");
    c.file("FILE", *file, "the package, or its URL").type("PACKAGE").required();
    c.action([file] {
        const PackageReader package = open_package(*file);
        nlohmann::json j = describe_package(package);
        const KnownCosts known = known_costs(costs_key(package));
        const std::vector<EffectCost> costs = effect_costs(package, {}, known);
        for (std::size_t i = 0; i < costs.size(); ++i) add_costs_of(costs[i], j["effects"][i]);
        j["costs_of_effects"] = origin_of(known);
        print_package(j, costs, known);
        results().update(j);
        return int(Exit::ok);
    });
}

}  // namespace vantage
