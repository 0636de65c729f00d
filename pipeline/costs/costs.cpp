#include "pipeline/costs/costs.h"

#include <nlohmann/json.hpp>

namespace vantage {
namespace {

using nlohmann::json;

void put(json& to, const char* key, const std::optional<double>& value) {
    if (value) to[key] = *value;
}

void take(const json& from, const char* key, std::optional<double>& value) {
    if (from.contains(key)) value = from[key].get<double>();
}

json json_of(const TrialCosts& c) {
    json out{{"setting", c.trial.setting},
             {"value", c.trial.value},
             {"usual", c.trial.usual},
             {"note", c.trial.note},
             {"prepare", c.trial.prepare},
             {"show", c.trial.show},
             {"frames", c.trial.frames},
             {"whole_frame", c.trial.whole_frame},
             {"prepare_seconds", c.prepare_seconds},
             {"frame_ms", c.frame_ms},
             {"default_seconds", c.default_seconds},
             {"default_ms", c.default_ms},
             {"psnr", c.psnr},
             {"ssim", c.ssim}};
    put(out, "memory_bytes", c.memory_bytes);
    put(out, "package_bytes", c.package_bytes);
    return out;
}

TrialCosts trial_of(const json& j) {
    TrialCosts c;
    c.trial = {j.at("setting"), j.at("value"), j.at("usual"),  j.value("note", ""),
               j.at("prepare"), j.at("show"),  j.at("frames"), j.at("whole_frame")};
    c.prepare_seconds = j.at("prepare_seconds").get<std::vector<double>>();
    c.frame_ms = j.at("frame_ms").get<std::vector<double>>();
    c.default_seconds = j.at("default_seconds").get<std::vector<double>>();
    c.default_ms = j.at("default_ms").get<std::vector<double>>();
    c.psnr = j.at("psnr").get<std::vector<double>>();
    c.ssim = j.at("ssim").get<std::vector<double>>();
    take(j, "memory_bytes", c.memory_bytes);
    take(j, "package_bytes", c.package_bytes);
    return c;
}

json json_of(const ScanCosts& s) {
    json out{{"name", s.name},
             {"key", s.key},
             {"input", s.input},
             {"photos", s.photos},
             {"triangles", s.triangles},
             {"width", s.width},
             {"height", s.height},
             {"picture", s.picture},
             {"photo_bytes", s.photo_bytes},
             {"held_out", s.held_out},
             {"excluded", s.excluded},
             {"complete", s.complete},
             {"trials", json::array()},
             {"recipes", json::array()}};
    put(out, "whole_seconds", s.whole_seconds);
    put(out, "whole_bytes", s.whole_bytes);
    for (const TrialCosts& c : s.trials) out["trials"].push_back(json_of(c));
    for (const Recipe& r : s.recipes)
        out["recipes"].push_back({{"purpose", r.purpose},
                                  {"reason", r.reason},
                                  {"commands", r.commands},
                                  {"costs", json_of(r.costs)}});
    return out;
}

ScanCosts scan_of(const json& j) {
    ScanCosts s;
    s.name = j.at("name");
    s.key = j.at("key");
    s.input = j.at("input");
    s.photos = j.at("photos");
    s.triangles = j.at("triangles");
    s.width = j.at("width");
    s.height = j.at("height");
    s.picture = j.at("picture");
    s.photo_bytes = j.at("photo_bytes");
    s.held_out = j.at("held_out");
    s.excluded = j.at("excluded");
    s.complete = j.at("complete");
    take(j, "whole_seconds", s.whole_seconds);
    take(j, "whole_bytes", s.whole_bytes);
    for (const json& c : j.at("trials")) s.trials.push_back(trial_of(c));
    for (const json& r : j.at("recipes"))
        s.recipes.push_back({r.at("purpose"), r.at("reason"), r.at("commands"), trial_of(r.at("costs"))});
    return s;
}

}  // namespace

json to_json(const Costs& costs) {
    json out{{"version", costs.version},   {"date", costs.date},   {"processor", costs.processor},
             {"renderer", costs.renderer}, {"cores", costs.cores}, {"scans", json::array()}};
    for (const ScanCosts& s : costs.scans) out["scans"].push_back(json_of(s));
    return out;
}

Costs costs_of(const json& j) {
    Costs out{j.at("version"), j.at("date"), j.at("processor"), j.at("renderer"), j.at("cores"), {}};
    for (const json& s : j.at("scans")) out.scans.push_back(scan_of(s));
    return out;
}

}  // namespace vantage
