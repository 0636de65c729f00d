#include "pipeline/costs/cost_trials.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/output/meta.h"
#include "scene/package/contents/effects.h"

namespace vantage {
namespace {

/// A trial of an option of `vantage prepare`.
CostTrial prepared(const std::string& option, const std::string& value, const std::string& usual,
                   bool frames = false) {
    return {option, value, usual, "", {option, value}, {}, frames, false};
}

/// A trial of an option of vantage-player.
CostTrial shown(const std::string& option, const std::string& value, const std::string& usual) {
    return {option, value, usual, "", {}, {option, value}, true, false};
}

CostTrial noted(CostTrial trial, const std::string& note) {
    trial.note = note;
    return trial;
}

int longest_side(const PackageReader& package) {
    std::uint32_t out = 0;
    for (const package::PhotoRecord& p : package.photos()) out = std::max({out, p.width, p.height});
    return int(out);
}

/// Trials that turn off effects that are on, and turn on effects that validation with held-out photos
/// rejected.
std::vector<CostTrial> effect_trials(const PackageReader& whole) {
    std::vector<CostTrial> out;
    for (const auto& e : parse_meta(whole).value("effects", nlohmann::json::array())) {
        const EffectRow& row = effect_row(e.value("name", ""));
        const bool on = e.value("on", false);
        const bool content = row.effect == Effect::points || row.effect == Effect::image_sets ||
                             row.effect == Effect::scalar_fields;
        if (content || (!on && !e.contains("judged"))) continue;
        CostTrial t =
            prepared("--effect", std::string(row.option) + (on ? "=off" : "=on"), on ? "on" : "off", true);
        t.whole_frame = row.effect == Effect::background;
        out.push_back(t);
    }
    return out;
}

}  // namespace

std::vector<CostTrial> cost_trials(const PackageReader& whole, bool prepares) {
    const int side = longest_side(whole);
    std::vector<CostTrial> out{{}};
    const auto add = [&](std::vector<CostTrial> more) {
        for (CostTrial& t : more)
            if (prepares || t.prepare.empty()) out.push_back(std::move(t));
    };
    add({prepared("--max-photo-size", std::to_string(side / 2), "full size", true),
         shown("--max-photos", "2", window_photos), shown("--max-photos", "8", window_photos),
         noted(prepared("--preset", "preview", "default", true), "photos of at most 1024 px"),
         shown("--blend", "average", "lumigraph"),
         prepared("--border-distance", "jfa^2", "exact without a GPU")});
    if (prepares) add(effect_trials(whole));
    CostTrial all_photos = shown("--max-photos", "0", window_photos);
    all_photos.value = "all";
    add({prepared("--refine", "off", "full", true),
         prepared("--validate", "off", "on"),
         shown("--max-photos", "1", window_photos),
         all_photos,
         shown("--blend", "best", "lumigraph"),
         noted(prepared("--preset", "ci", "default", true), "photos of at most 640 px, one thread"),
         prepared("--max-photo-size", std::to_string(side / 4), "full size", true),
         noted(prepared("--threads", "1", "all cores"), "leaves the others to other programs"),
         noted(prepared("--renderer", "opengl", "cpu without a GPU"), "the default with a GPU"),
         {"--thumbnails", "on", "off", "for slow connections", {}, {"--thumbnails"}, true, false},
         prepared("--thumbnail-size", "128", "512"),
         prepared("--thumbnail-size", "1024", "512")});
    const auto has = [&](Effect effect) { return (whole.scene().effects >> int(effect) & 1) != 0; };
    if (has(Effect::per_fragment))
        add({{"--coordinates",
              "vertex",
              "fragment",
              "stored by --vertex-coordinates",
              {"--vertex-coordinates"},
              {"--coordinates", "vertex"},
              true,
              false}});
    if (has(Effect::transparency))
        add({shown("--transparency", "approximate", "exact"), shown("--transparency", "off", "exact")});
    return out;
}

}  // namespace vantage
