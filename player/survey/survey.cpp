#include "player/survey/survey.h"

#include <cmath>

#include "base/text/translation.h"
#include "player/survey/number_text.h"

namespace vantage {
namespace {

constexpr int all_digits = 12;

std::string number_or_nothing(const std::optional<double>& value, double size = 0) {
    return value ? number_text(*value, all_digits, size) : "";
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

std::string points_text(const Measurement& m) {
    std::string out;
    for (const SurveyPoint& p : m.points) {
        if (!out.empty()) out += "; ";
        for (int axis = 0; axis < 3; ++axis)
            out.append(axis ? " " : "")
                .append(number_text(p.position[axis], all_digits, p.position.cwiseAbs().maxCoeff()));
    }
    return out;
}

}  // namespace

std::string direction_text(const Eigen::Vector3d& d) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(d[axis]) == 1) return std::string(d[axis] > 0 ? "+" : "-") + "xyz"[axis];
    return number_text(d.x(), 4, 1) + " " + number_text(d.y(), 4, 1) + " " + number_text(d.z(), 4, 1);
}

std::string survey_csv(const Survey& s) {
    const KeepEnglish notes;
    std::string out = "name,measure,value,uncertainty,unit,note,points\n";
    for (const Measurement& m : s.measurements) {
        const Measured is = evaluate(m, s.scale, s.up);
        out += quoted(m.name) + "," + name_of(m.measure) + "," + number_or_nothing(is.value, is.size) + "," +
               number_or_nothing(is.uncertainty) + "," + is.unit + "," + quoted(is.note) + "," +
               quoted(points_text(m)) + "\n";
    }
    return out;
}

}  // namespace vantage
