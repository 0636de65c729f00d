#include "pipeline/results/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "pipeline/settings/config_files.h"
#include "pipeline/settings/settings.h"
#include "scene/error.h"

namespace vantage {
namespace {

/// Measurements of one value of an option on one scene.
struct Cost {
    std::string option, value, scene;
    std::map<std::string, double> values;
};

std::vector<Cost> read_costs() {
    const std::filesystem::path file = find_config_file("costs.json");
    std::ifstream in(file);
    try {
        std::vector<Cost> out;
        const nlohmann::json whole = nlohmann::json::parse(in);
        for (const auto& c : whole.at("costs"))
            out.push_back({c.at("option"), c.at("value"), c.at("scene"), c.at("values")});
        return out;
    } catch (const nlohmann::json::exception&) {
        throw Error(Exit::usage, file.string() + ": expected a file written by vantage-bench --costs");
    }
}

/// A comparison over the scenes on which both values were measured.
struct Compared {
    double mean = 0, least = 0, most = 0;
    std::size_t scenes = 0;
};
template <class Compare>
Compared compare(const std::vector<Cost>& costs, const std::string& option, const std::string& value,
                 const std::string& reference, const std::string& metric, const Compare& between) {
    Compared out;
    for (const Cost& a : costs) {
        if (a.option != option || a.value != value || !a.values.contains(metric)) continue;
        for (const Cost& b : costs) {
            if (b.option != option || b.value != reference || b.scene != a.scene ||
                !b.values.contains(metric))
                continue;
            const double d = between(a.values.at(metric), b.values.at(metric));
            if (!std::isfinite(d)) continue;
            out.least = out.scenes ? std::min(out.least, d) : d;
            out.most = out.scenes ? std::max(out.most, d) : d;
            out.mean += d;
            ++out.scenes;
        }
    }
    if (out.scenes) out.mean /= double(out.scenes);
    return out;
}

/// The mean of a metric over the scenes.
double plain(const std::vector<Cost>& costs, const std::string& option, const std::string& value,
             const std::string& metric) {
    return compare(costs, option, value, value, metric, [](double a, double) { return a; }).mean;
}

std::set<std::string> measured_values(const std::vector<Cost>& costs, const std::string& option) {
    std::set<std::string> out;
    for (const Cost& c : costs)
        if (c.option == option) out.insert(c.value);
    return out;
}

std::string line(const std::string& option, const std::string& value, const std::string& words) {
    return fmt::format("{:<18} {:<10} {}", option, value, words);
}

std::string decibels(const Compared& d) {
    if (std::abs(d.mean) < 0.005 && d.most - d.least < 0.05) return "identical picture";
    return fmt::format("{:+.2f} dB ({:+.2f} to {:+.2f} over {} scenes)", d.mean, d.least, d.most, d.scenes);
}

/// Compared with another value: ratios of preparation time, package size and frame time, and PSNR.
std::string compared_with(const std::vector<Cost>& costs, const std::string& option, const std::string& value,
                          const std::string& reference) {
    const auto ratio = [&](const char* metric) {
        return compare(costs, option, value, reference, metric, [](double a, double b) { return a / b; });
    };
    const Compared error =
        compare(costs, option, value, reference, "psnr", [](double a, double b) { return a - b; });
    if (!error.scenes) return "not measured";
    std::string out;
    // Differences within the timing noise are omitted.
    const auto add = [&](const char* metric, const char* what, double noise) {
        const Compared r = ratio(metric);
        if (r.scenes && std::abs(r.mean - 1) > noise) out += fmt::format("{:.2f}x the {}, ", r.mean, what);
    };
    add("prepare_s", "time", 0.15);
    add("package_bytes", "size", 0.005);
    add("frame_ms", "frame time", 0.15);
    return out + decibels(error);
}

std::string explain_distance(const std::vector<Cost>& costs, const std::string& method) {
    if (!measured_values(costs, "distance").contains(method)) return "not measured";
    const auto value = [&](const char* of, const char* metric) {
        return plain(costs, "distance", of, metric);
    };
    const std::string takes = fmt::format("{:.0f} ms per photo", value(method.c_str(), "photo_ms"));
    const double off = value(method.c_str(), "distance_worst");
    if (off == 0) return takes + ", no loss";
    return fmt::format("{} (exact: {:.0f}), largest distance error {:.2f} px", takes,
                       value("exact", "photo_ms"), off);
}

/// The measured value nearest in ratio.
std::string nearest(const std::vector<Cost>& costs, const std::string& option, double value) {
    std::string best;
    double least = std::numeric_limits<double>::infinity();
    for (const std::string& v : measured_values(costs, option)) {
        const double off = std::abs(std::log(std::max(1e-9, std::stod(v)) / std::max(1e-9, value)));
        if (off < least) least = off, best = v;
    }
    return best;
}

std::string explain_size(const std::vector<Cost>& costs, int size, int longest) {
    const auto at = [&](double share) {
        return compared_with(costs, "photo-size", nearest(costs, "photo-size", share), "1.0");
    };
    if (size == 0 || size >= longest) return "no loss; at half the side length: " + at(0.5);
    const double share = double(size) / std::max(1, longest);
    return fmt::format("{:.2f} of {} px: {} (measured at {})", share, longest, at(share),
                       nearest(costs, "photo-size", share));
}

std::string explain_number(const std::vector<Cost>& costs, const std::string& option, double value,
                           double reference) {
    const std::string v = nearest(costs, option, value), u = nearest(costs, option, reference);
    if (v.empty()) return "not measured";
    if (v != u)
        return fmt::format("compared with {}: {} (measured at {})", u, compared_with(costs, option, v, u), v);
    std::string out = "default";
    const std::set<std::string> all = measured_values(costs, option);
    for (const std::string& other :
         {*std::ranges::min_element(all, {}, [](const auto& t) { return std::stod(t); }),
          *std::ranges::max_element(all, {}, [](const auto& t) { return std::stod(t); })})
        if (other != v) out += fmt::format("; {}: {}", other, compared_with(costs, option, other, v));
    return out;
}

}  // namespace

std::vector<std::string> explain(const PrepareSettings& s, const SceneInput& scene,
                                 const PackageReader& package) {
    const std::vector<Cost> costs = read_costs();
    const PrepareSettings defaults;
    int longest = 0;
    for (const PhotoInput& p : scene.photos)
        longest = std::max({longest, p.camera.intrinsics.width, p.camera.intrinsics.height});
    std::vector<std::string> out{line("photo-size", s.photo_size ? std::to_string(s.photo_size) : "full",
                                      explain_size(costs, s.photo_size, longest))};
    if (s.distance == DistanceMethod::automatic)
        for (const DistanceMethod m : {DistanceMethod::exact, DistanceMethod::jfa_squared})
            out.push_back(
                line("distance", "auto",
                     fmt::format("{}, {}: {}", name(m),
                                 m == DistanceMethod::exact ? "on a software renderer" : "on a GPU",
                                 explain_distance(costs, name(m)))));
    else
        out.push_back(line("distance", name(s.distance), explain_distance(costs, name(s.distance))));
    const auto number = [&](const char* option, double value, double common) {
        out.push_back(line(option, fmt::format("{:g}", value), explain_number(costs, option, value, common)));
    };
    number("border-width", s.border_width, defaults.border_width);
    number("border-threshold", s.border_threshold, defaults.border_threshold);
    number("thumbnail", s.thumbnail, defaults.thumbnail);
    out.back() += "; PSNR of the first picture, rendered from thumbnails only";
    number("cluster-triangles", s.cluster_triangles, defaults.cluster_triangles);
    const bool fragment = effect_on(package.scene(), Effect::per_fragment);
    out.push_back(line(
        "per-fragment", fragment ? "on" : "off",
        fmt::format("compared with {}: {}", fragment ? "off" : "on",
                    compared_with(costs, "per-fragment", fragment ? "on" : "off", fragment ? "off" : "on"))));
    return out;
}

}  // namespace vantage
