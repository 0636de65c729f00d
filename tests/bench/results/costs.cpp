#include "tests/bench/results/costs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/error.h"

namespace vantage::bench {
namespace {

/// The option of `vantage prepare` that a measurement varies, and its value; both empty if it varies none.
struct Value {
    std::string option, value;
};
Value value_of(const Measurement& m, double most_pixels) {
    if (m.sweep == "border" && m.curve == "masks at 1/2") return {"distance", m.setting};
    if (m.sweep == "preparing") return {m.curve, m.setting};
    if (m.sweep == "presets" && m.setting == "full exact")
        return {"per-fragment", m.curve == "coordinates per fragment" ? "on" : "off"};
    // Photos differ in size, so the value is relative: the fraction of the side length that is kept.
    if (m.sweep == "photos" && m.values.contains("pixels"))
        return {"photo-size", nlohmann::json(std::sqrt(m.values.at("pixels") / most_pixels)).dump()};
    return {};
}

double most_pixels(std::span<const Measurement> all, const std::string& scene) {
    double most = 0;
    for (const Measurement& m : all)
        if (m.scene == scene && m.values.contains("pixels")) most = std::max(most, m.values.at("pixels"));
    return most;
}

}  // namespace

void write_costs(const std::filesystem::path& file, const std::vector<std::string>& about,
                 std::span<const Measurement> measurements) {
    nlohmann::json costs = nlohmann::json::array();
    for (const Measurement& m : measurements) {
        const auto [option, value] = value_of(m, most_pixels(measurements, m.scene));
        if (option.empty()) continue;
        nlohmann::json values;
        for (const auto& [name, v] : m.values)
            if (std::isfinite(v)) values[name] = std::stod(nlohmann::json(float(v)).dump());
        costs.push_back({{"option", option}, {"value", value}, {"scene", m.scene}, {"values", values}});
    }
    std::ofstream out(file);
    out << nlohmann::json{{"machine", about}, {"costs", costs}}.dump(1) << '\n';
    if (!out.flush()) throw Error(Exit::storage, file.string() + ": cannot be written");
}

}  // namespace vantage::bench
