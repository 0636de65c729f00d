#include "scene/package/contents/scalar_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "base/text/json_text.h"

namespace vantage {
namespace {

/// The names of the fields in META, or numbers if META is not as expected.
std::vector<std::string> field_names(const PackageReader& package, std::size_t count) {
    std::vector<std::string> names = texts_in(package.meta(), "scalars");
    names.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        if (names[i].empty()) names[i] = std::to_string(i + 1);
    return names;
}

}  // namespace

void summarize_values(ScalarField& field) {
    field.low = field.high = field.least_positive = 0;
    field.without = 0;
    field.counts = {};
    double low = std::numeric_limits<double>::infinity(), high = -low, positive = low;
    for (const float value : field.values) {
        if (!std::isfinite(value)) {
            ++field.without;
            continue;
        }
        const double v = value;
        low = std::min(low, v), high = std::max(high, v);
        if (v > 0) positive = std::min(positive, v);
    }
    if (field.without == field.values.size()) return;
    field.low = low, field.high = high;
    field.least_positive = std::isfinite(positive) ? positive : 0;
    const double scale = high > low ? double(field.counts.size()) / (high - low) : 0;
    for (const float v : field.values)
        if (std::isfinite(v))
            ++field.counts[std::min(field.counts.size() - 1, std::size_t((double(v) - low) * scale))];
}

std::vector<ScalarField> read_fields(const PackageReader& package) {
    std::vector<ScalarField> out;
    const package::SceneRecord& scene = package.scene();
    if (!effect_on(scene, Effect::scalar_fields)) return out;
    const auto all = package.records<float>(package::Type::scalars);
    if (scene.vertices == 0 || all.size() % scene.vertices != 0 ||
        all.size() / scene.vertices != scene.scalar_fields)
        throw Error(Exit::damaged,
                    package.path().string() + ": VSCL: length does not match the scene's counts");
    const std::vector<std::string> names = field_names(package, scene.scalar_fields);
    for (std::size_t i = 0; i < names.size(); ++i) {
        out.push_back({.name = names[i], .values = all.subspan(i * scene.vertices, scene.vertices)});
        summarize_values(out.back());
    }
    return out;
}

int field_named(std::span<const ScalarField> fields, std::string_view name) {
    std::string known;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].name == name) return int(i);
        known += (known.empty() ? "" : ", ") + fields[i].name;
    }
    const auto alike = std::ranges::find(
        fields, comparable_name(name), [](const ScalarField& field) { return comparable_name(field.name); });
    if (alike != fields.end()) return int(alike - fields.begin());
    throw Error(Exit::usage, "no scalar field '" + std::string(name) + "', " +
                                 (known.empty() ? "the package has none" : "expected one of " + known) +
                                 "; 'vantage prepare SCAN -o PACKAGE --deviation-from MESH' measures "
                                 "deviation-from-MESH, and the per-vertex values of a PLY file are kept");
}

ValueRange whole_range(const ScalarField& field, bool centered, bool logarithmic) {
    ValueRange r{field.low, field.high};
    if (logarithmic) {
        r.low = field.least_positive > 0 ? field.least_positive : 1;
        if (!(r.high > r.low)) r.high = 10 * r.low;
        return r;
    }
    if (centered) r.high = std::max(std::abs(r.low), std::abs(r.high)), r.low = -r.high;
    if (!(r.high > r.low)) r.low -= 0.5, r.high += 0.5;
    if (!(r.high > r.low)) r.high = std::nextafter(r.low, std::numeric_limits<double>::infinity());
    return r;
}

}  // namespace vantage
