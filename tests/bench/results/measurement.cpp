#include "tests/bench/results/measurement.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace vantage::bench {
namespace {

using Kind = Metric::Kind;
constexpr double same = 0.002, timed = 0.25;

// PSNR and SSIM are measured against the truth after matching exposure. Percentages refer to the pixels or
// points for which a correct result is possible.
constexpr Metric table[] = {
    {"psnr", "PSNR", "dB", Kind::error, false, same},
    {"ssim", "SSIM", "", Kind::error, false, same},
    {"worst", "worst 0.1 % of the pixels", "of 255", Kind::error, true, 0.01},
    {"uncoloured", "left uncolored", "%", Kind::error, true, 0.01},
    {"psnr_exact", "PSNR against the exact setting", "dB", Kind::error, false, same},
    {"weight_mean", "mean error of the border weight", "of 255", Kind::error, true, same},
    {"weight_worst", "error of the border weight, worst 0.1 %", "of 255", Kind::error, true, same},
    {"distance_worst", "largest error of the border distance", "px", Kind::error, true, same},
    {"false_hidden", "visible but classified as hidden", "%", Kind::error, true, same},
    {"false_visible", "hidden but classified as visible", "%", Kind::error, true, same},
    {"px_median", "median error", "px", Kind::error, true, same},
    {"px_worst", "worst 0.1 %", "px", Kind::error, true, same},
    {"uncovered", "not covered, though visible in a photo", "%", Kind::error, true, same},
    {"changes", "photos exchanged per frame", "", Kind::error, true, same},
    {"photo_ms", "preparation per photo", "ms", Kind::time, true, timed},
    {"frame_ms", "frame time", "ms", Kind::time, true, timed},
    {"open_ms", "opening", "ms", Kind::time, true, timed},
    {"first_ms", "first picture", "ms", Kind::time, true, timed},
    {"plan_ms", "planning time per frame", "ms", Kind::time, true, timed},
    {"fetch_ms", "reading a tile into memory", "ms", Kind::time, true, timed},
    {"tile_ms", "loading a tile into a texture", "ms", Kind::time, true, timed},
    {"point_ns", "per point", "ns", Kind::time, true, timed},
    {"photo_bytes", "per photo", "B", Kind::bytes, true, same},
    {"read_bytes", "read per view", "B", Kind::bytes, true, same},
    {"texel_bytes", "per texel", "B", Kind::bytes, true, same},
    {"vertex_bytes", "size per vertex and photo", "B", Kind::bytes, true, same},
    {"photos", "photos blended", "", Kind::other, true, same},
    {"exponent", "angle exponent", "", Kind::other, true, same},
    {"sharpness", "angle at which a photo's weight is 1/e", "rad", Kind::other, true, same},
    {"triangle_px", "triangle size", "px", Kind::other, true, same},
};

}  // namespace

std::span<const Metric> metrics() { return table; }

const Metric& metric(const std::string& name) {
    for (const Metric& m : table)
        if (name == m.name) return m;
    throw std::out_of_range(name + ": unknown metric");
}

std::optional<double> finite_value(const Measurement& row, const std::string& metric) {
    const auto found = row.values.find(metric);
    if (found == row.values.end() || !std::isfinite(found->second)) return std::nullopt;
    return found->second;
}

nlohmann::json to_json(const Measurement& m) {
    nlohmann::json exhibits = nlohmann::json::array();
    for (const Exhibit& e : m.exhibits) exhibits.push_back({{"caption", e.caption}, {"file", e.file}});
    return {{"sweep", m.sweep}, {"scene", m.scene},   {"curve", m.curve},   {"setting", m.setting},
            {"exact", m.exact}, {"chosen", m.chosen}, {"values", m.values}, {"exhibits", exhibits}};
}

Measurement measurement(const nlohmann::json& j) {
    Measurement m{j.at("sweep"), j.at("scene"),  j.at("curve"),  j.at("setting"),
                  j.at("exact"), j.at("chosen"), j.at("values"), {}};
    for (const auto& e : j.at("exhibits")) m.exhibits.push_back({e.at("caption"), e.at("file")});
    return m;
}

}  // namespace vantage::bench
