#include "tests/bench/results/tables.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/text/error.h"

namespace vantage::bench {
namespace {

constexpr const char* format = "vantage-bench 1";

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

/// The metric's unit; empty for an unknown metric, which may come from another version.
std::string unit(const std::string& name) {
    for (const Metric& m : metrics())
        if (name == m.name) return m.unit;
    return "";
}

/// The shortest text that is parsed as the same number.
std::string exactly(double value) { return std::isfinite(value) ? nlohmann::json(value).dump() : ""; }

Measurement finite_part(Measurement m) {
    std::erase_if(m.values, [](const auto& v) { return !std::isfinite(v.second); });
    return m;
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw Error(Exit::storage, file.string() + ": cannot be written");
}

}  // namespace

void write_csv(const std::filesystem::path& file, std::span<const Measurement> measurements) {
    std::string out = "sweep,scene,curve,setting,exact,chosen,metric,unit,value\r\n";
    for (const Measurement& m : measurements)
        for (const auto& [name, value] : m.values) {
            for (const std::string& text : {m.sweep, m.scene, m.curve, m.setting}) out += quoted(text) + ",";
            for (const bool flag : {m.exact, m.chosen}) out += flag ? "1," : "0,";
            out += quoted(name) + "," + quoted(unit(name)) + "," + exactly(value) + "\r\n";
        }
    write(file, out);
}

void write_json(const std::filesystem::path& file, const Run& run) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Measurement& m : run.measurements) rows.push_back(to_json(finite_part(m)));
    const nlohmann::json out = {{"format", format},
                                {"version", run.version},
                                {"effort", run.effort},
                                {"machine", run.machine},
                                {"measurements", rows}};
    write(file, out.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Run read_json(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(Exit::input, file.string() + ": cannot be read");
    try {
        const nlohmann::json j = nlohmann::json::parse(in);
        if (j.at("format") != format)
            throw Error(Exit::input, file.string() + ": format " + j.at("format").dump() + ", expected \"" +
                                         format + "\"");
        Run run{j.at("version"), j.at("effort"), j.at("machine"), {}};
        for (const nlohmann::json& row : j.at("measurements")) run.measurements.push_back(measurement(row));
        return run;
    } catch (const nlohmann::json::exception& e) {
        throw Error(Exit::input, file.string() + ": not a table of measurements: " + e.what());
    }
}

}  // namespace vantage::bench
