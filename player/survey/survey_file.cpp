#include "player/survey/survey_file.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "scene/error.h"
#include "scene/replace_file.h"

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

Json json_of(const SurveyPoint& p) {
    Json out{{"position", {p.position.x(), p.position.y(), p.position.z()}},
             {"uncertainty", optional_number(p.uncertainty)}};
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

/// Reads values, and says where in the file one is missing or wrong.
class Reading {
  public:
    explicit Reading(const std::filesystem::path& file) : file_(file) {}
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(Exit::input, file_.string() + ": " + what);
    }

    const Json& at(const Json& j, const char* key, const std::string& where) const {
        if (!j.is_object() || !j.contains(key)) fail(where + " has no \"" + key + "\"");
        return j[key];
    }
    double number(const Json& j, const std::string& what) const {
        if (!j.is_number() || !std::isfinite(j.get<double>())) fail(what + ": expected a number");
        return j.get<double>();
    }
    std::string text(const Json& j, const std::string& what) const {
        if (!j.is_string()) fail(what + ": expected text");
        return j.get<std::string>();
    }
    const Json& list(const Json& j, const std::string& what) const {
        if (!j.is_array()) fail(what + ": expected a list");
        return j;
    }
    Eigen::Vector3d vector(const Json& j, const std::string& what) const {
        if (list(j, what).size() != 3) fail(what + ": expected three numbers");
        return {number(j[0], what), number(j[1], what), number(j[2], what)};
    }
    Unit unit(const Json& j, const std::string& what) const {
        const auto unit = unit_named(text(j, what));
        if (!unit) fail(what + ": expected m, cm, mm, ft, in or units");
        return *unit;
    }

  private:
    const std::filesystem::path& file_;
};

Scale scale_in(const Json& j, const Reading& read) {
    Scale out{read.number(read.at(j, "length", "the scale"), "the scale's length"),
              read.unit(read.at(j, "unit", "the scale"), "the scale's unit"),
              read.unit(read.at(j, "shown", "the scale"), "the scale's shown unit"),
              read.number(read.at(j, "relative_uncertainty", "the scale"), "the scale's uncertainty")};
    if (!(out.length > 0) || !(out.relative >= 0)) read.fail("the scale: expected a length above 0");
    if (out.unit == Unit::unknown) out = {};
    return out;
}

SurveyPoint point_in(const Json& j, const std::string& where, const Reading& read) {
    SurveyPoint out{read.vector(read.at(j, "position", where), where + "'s position")};
    const Json& uncertainty = read.at(j, "uncertainty", where);
    if (!uncertainty.is_null()) out.uncertainty = read.number(uncertainty, where + "'s uncertainty");
    if (out.uncertainty && *out.uncertainty < 0) read.fail(where + "'s uncertainty: expected at least 0");
    if (j.contains("photo")) out.photo = read.text(j["photo"], where + "'s photo");
    return out;
}

Measurement measurement_in(const Json& j, const std::string& where, const Reading& read) {
    Measurement out{read.text(read.at(j, "name", where), where + "'s name"), Measure::point, {}};
    const std::string measure = read.text(read.at(j, "measure", where), where + "'s measure");
    const auto known = measure_named(measure);
    if (!known) read.fail(where + ": unknown measure \"" + measure + "\"");
    out.measure = *known;
    for (const Json& p : read.list(read.at(j, "points", where), where + "'s points"))
        out.points.push_back(point_in(p, where + ", point " + std::to_string(out.points.size() + 1), read));
    if (out.points.size() < fewest_points(*known) || out.points.size() > most_points(*known))
        read.fail(where + ": " + std::to_string(out.points.size()) +
                  " points are not what a measurement of " + measure + " has");
    return out;
}

}  // namespace

SurveyFile survey_file_of(const std::filesystem::path& package, bool remote) {
    const std::string name = package.stem().string() + ".measurements.json";
    return {remote ? std::filesystem::path(name) : package.parent_path() / name};
}

std::string survey_text(const Survey& s) {
    Json list = Json::array();
    for (const Measurement& m : s.measurements) list.push_back(json_of(m, s));
    const Json all{{"format", format},
                   {"version", version},
                   {"up", {s.up.x(), s.up.y(), s.up.z()}},
                   {"scale",
                    {{"length", s.scale.length},
                     {"unit", name_of(s.scale.unit)},
                     {"shown", name_of(shown_unit(s.scale))},
                     {"relative_uncertainty", s.scale.relative}}},
                   {"measurements", list}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Survey survey_from(const std::string& text, const std::filesystem::path& file) {
    const Reading read(file);
    const Json j = Json::parse(text, nullptr, false);
    if (j.is_discarded() || !j.is_object() || !j.contains("format") || j["format"] != format)
        read.fail("is not a file of measurements, or is incomplete");
    if (read.number(read.at(j, "version", "the file"), "the version") != version)
        read.fail("is of another version than " + std::to_string(version));
    Survey out;
    out.scale = scale_in(read.at(j, "scale", "the file"), read);
    out.up = read.vector(read.at(j, "up", "the file"), "\"up\"");
    const double length = out.up.stableNorm();
    if (!(length > 0)) read.fail("\"up\": expected a direction");
    out.up /= length;
    for (const Json& m : read.list(read.at(j, "measurements", "the file"), "\"measurements\""))
        out.measurements.push_back(
            measurement_in(m, "measurement " + std::to_string(out.measurements.size() + 1), read));
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
                                       ": is not as it was left, so that it is not replaced; "
                                       "move it away to save measurements");
    const std::string text = survey_text(survey);
    replace_file(file.path, text);
    file.content = text;
}

}  // namespace vantage
