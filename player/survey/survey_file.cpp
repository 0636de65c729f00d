#include "player/survey/survey_file.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "base/text/located_json.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "vantage-measurements";
constexpr int version = 1;

std::optional<std::string> content_of(const std::filesystem::path& path) {
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) return {};
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad()) throw Error(Exit::input, path.string() + ": cannot be read");
    return text;
}

Json optional_number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

/// Negative zeros become zero.
Json json_of(const Eigen::Vector3d& v) { return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}; }

Json json_of(const SurveyPoint& p) {
    Json out{{"position", json_of(p.position)}, {"uncertainty", optional_number(p.uncertainty)}};
    if (p.pointing > 0) out["pointing"] = p.pointing;
    if (!p.photo.empty()) out["photo"] = p.photo;
    return out;
}

Json json_of(const Measurement& m, const Survey& s) {
    Json points = Json::array();
    for (const SurveyPoint& p : m.points) points.push_back(json_of(p));
    const Measured is = evaluate(m, s.scale, s.up);
    return {{"name", m.name},
            {"measure", name_of(m.measure)},
            {"points", points},
            {"value", optional_number(is.value)},
            {"uncertainty", optional_number(is.uncertainty)},
            {"unit", is.unit},
            {"note", is.note}};
}

constexpr double most = 1e12;
constexpr std::size_t max_listed = 1 << 20;

double number_in(const LocatedJson& object, const char* key) { return object.at(key).number(-most, most); }

std::string text_in(const LocatedJson& object, const char* key) {
    constexpr std::size_t max_bytes = 1 << 20;
    return object.at(key).text(max_bytes, true);
}

Unit unit_in(const LocatedJson& scale, const char* key) {
    const auto unit = unit_named(text_in(scale, key));
    if (!unit) scale.at(key).fail("m, cm, mm, ft, in or units");
    return *unit;
}

Scale scale_in(const LocatedJson& j) {
    Scale out{number_in(j, "length"), unit_in(j, "unit"), unit_in(j, "shown"),
              number_in(j, "relative_uncertainty")};
    if (!(out.length > 0)) j.at("length").fail("a number above 0");
    if (!(out.relative >= 0)) j.at("relative_uncertainty").fail("a number of at least 0");
    if (j.has("between")) {
        const std::vector<LocatedJson> ends = j.at("between").items(2);
        if (ends.size() != 2) j.at("between").fail("two points");
        out.between = {ends[0].vector(), ends[1].vector()};
    }
    if (out.unit == Unit::unknown) out = {};
    return out;
}

SurveyPoint point_in(const LocatedJson& j) {
    SurveyPoint out{j.at("position").vector()};
    if (const LocatedJson uncertainty = j.at("uncertainty"); !uncertainty.is_null())
        out.uncertainty = uncertainty.number(0, most);
    if (j.has("pointing")) out.pointing = j.at("pointing").number(0, most);
    if (j.has("photo")) out.photo = text_in(j, "photo");
    return out;
}

Measurement measurement_in(const LocatedJson& j) {
    Measurement out{text_in(j, "name"), Measure::point, {}};
    const auto known = measure_named(text_in(j, "measure"));
    if (!known) j.at("measure").fail("a kind of measurement");
    out.measure = *known;
    const LocatedJson points = j.at("points");
    for (const LocatedJson& p : points.items(max_listed)) out.points.push_back(point_in(p));
    if (out.points.size() < fewest_points(*known) || out.points.size() > max_points(*known))
        points.fail("as many points as the measurement has");
    return out;
}

}  // namespace

SurveyFile survey_file_of(const std::filesystem::path& package, bool remote) {
    const std::string name = package.stem().string() + ".measurements.json";
    return {remote ? std::filesystem::path(name) : package.parent_path() / name};
}

std::string survey_text(const Survey& s) {
    const KeepEnglish notes;
    Json list = Json::array();
    for (const Measurement& m : s.measurements) list.push_back(json_of(m, s));
    Json scale{{"length", s.scale.length},
               {"unit", name_of(s.scale.unit)},
               {"shown", name_of(shown_unit(s.scale))},
               {"relative_uncertainty", s.scale.relative}};
    if (s.scale.between)
        scale["between"] = {json_of(s.scale.between->front()), json_of(s.scale.between->back())};
    const Json all{{"format", format},
                   {"version", version},
                   {"up", json_of(s.up)},
                   {"scale", scale},
                   {"measurements", list}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Survey survey_from(const std::string& text, const std::filesystem::path& file) {
    constexpr int deepest = 8;
    const std::string name = file.string();
    const nlohmann::json value = parsed_json(text, name, deepest);
    std::vector<std::string> unknown;
    const LocatedJson all(name, value, unknown);
    if (text_in(all, "format") != format) all.at("format").fail(format);
    if (number_in(all, "version") != version) all.at("version").fail(std::to_string(version));
    Survey out;
    out.scale = scale_in(all.at("scale"));
    out.up = all.at("up").vector();
    const double length = out.up.stableNorm();
    if (!(length > 0)) all.at("up").fail("a direction");
    out.up /= length;
    for (const LocatedJson& m : all.at("measurements").items(max_listed))
        out.measurements.push_back(measurement_in(m));
    return out;
}

Survey read_survey(SurveyFile& file, const Survey& otherwise) {
    std::optional<std::string> content = content_of(file.path);
    Survey out = content ? survey_from(*content, file.path) : otherwise;
    file.content = std::move(content);
    return out;
}

void write_survey(SurveyFile& file, const Survey& survey) {
    if (content_of(file.path) != file.content)
        throw Error(Exit::storage, file.path.string() +
                                       ": was changed by another program and will not be replaced; move the "
                                       "file away to save measurements");
    const std::string text = survey_text(survey);
    replace_file(file.path, text);
    file.content = text;
}

}  // namespace vantage
