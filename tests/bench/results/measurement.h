#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vantage::bench {

/// A quantity that can be measured.
struct Metric {
    const char* name;   ///< key of Measurement::values
    const char* title;  ///< for axes and tables
    const char* unit;
    enum class Kind { error, time, bytes, other } kind;
    bool less_is_better;
    /// The relative difference between runs up to which a value counts as unchanged.
    double noise;
};
std::span<const Metric> metrics();
/// The metric with this name. Throws std::out_of_range if there is none.
const Metric& metric(const std::string& name);

/// The PSNR in dB that is stored for identical pictures; larger values are clamped to it.
constexpr double psnr_cap = 100;

/// A part of a picture that illustrates the numbers.
struct Exhibit {
    std::string caption;
    std::string file;  ///< JPEG, relative to the output folder
};

/// One point on a curve: the cost and the error of one value of a setting.
struct Measurement {
    std::string sweep;    ///< "border"
    std::string scene;    ///< "sceaux"
    std::string curve;    ///< the settings that are fixed along the curve: "weight maps at 1/2"
    std::string setting;  ///< value at this point: "jfa^2"
    bool exact = false;   ///< whether this is the exact value of the setting
    bool chosen = false;  ///< whether this is the program's default
    std::map<std::string, double> values;
    std::vector<Exhibit> exhibits;
};

/// The row's value for that metric; nullopt if it is missing or not finite.
std::optional<double> finite_value(const Measurement& row, const std::string& metric);

nlohmann::json to_json(const Measurement& m);
/// Throws nlohmann::json::exception.
Measurement measurement(const nlohmann::json& json);

}  // namespace vantage::bench
