#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vantage::bench {

/// A quantity that a measurement may hold.
struct Metric {
    const char* name;   ///< key of Measurement::values
    const char* title;  ///< for axes and tables
    const char* unit;
    enum class Kind { error, time, bytes, other } kind;
    bool less_is_better;
    /// Share by which it may move from run to run without having changed.
    double noise;
};
std::span<const Metric> metrics();
/// Throws std::out_of_range for a name that is not in the table.
const Metric& metric(const std::string& name);

/// dB; the PSNR of equal pictures, and the most that is stored.
constexpr double psnr_cap = 100;

/// A part of a picture that shows what the numbers mean.
struct Exhibit {
    std::string caption;
    std::string file;  ///< JPEG, relative to the bench's folder
};

/// One point of a curve: what one setting of a knob costs, and how far it is from the truth.
struct Measurement {
    std::string sweep;    ///< "border"
    std::string scene;    ///< "sceaux"
    std::string curve;    ///< what stays the same along a line: "masks at 1/2"
    std::string setting;  ///< the knob here: "jfa+1"
    bool exact = false;   ///< the knob's exact end
    bool chosen = false;  ///< what the product does if not told otherwise
    std::map<std::string, double> values;
    std::vector<Exhibit> exhibits;
};

/// The row's value of that metric; none if it lacks one, or if it is not finite.
std::optional<double> finite_value(const Measurement& row, const std::string& metric);

nlohmann::json to_json(const Measurement& m);
/// Throws nlohmann::json::exception.
Measurement measurement(const nlohmann::json& json);

}  // namespace vantage::bench
