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
    /// Relative difference between runs up to which a value counts as unchanged.
    double noise;
};
std::span<const Metric> metrics();
/// The metric with this name. Throws std::out_of_range for an unknown one.
const Metric& metric(const std::string& name);

/// PSNR of equal pictures in dB, and the maximum stored.
constexpr double psnr_cap = 100;

/// A part of a picture, to illustrate the numbers.
struct Exhibit {
    std::string caption;
    std::string file;  ///< JPEG, relative to the output folder
};

/// One point of a curve: the cost and the error of one value of a setting.
struct Measurement {
    std::string sweep;    ///< "border"
    std::string scene;    ///< "sceaux"
    std::string curve;    ///< the fixed settings along a line: "weight maps at 1/2"
    std::string setting;  ///< value at this point: "jfa^2"
    bool exact = false;   ///< the exact value of the setting
    bool chosen = false;  ///< the default of the program
    std::map<std::string, double> values;
    std::vector<Exhibit> exhibits;
};

/// The row's value of that metric; nullopt if it is missing or not finite.
std::optional<double> finite_value(const Measurement& row, const std::string& metric);

nlohmann::json to_json(const Measurement& m);
/// Renamed curves and settings get their current names. Throws nlohmann::json::exception.
Measurement measurement(const nlohmann::json& json);

}  // namespace vantage::bench
