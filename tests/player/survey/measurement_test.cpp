#include "player/survey/measurement.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "player/survey/number_text.h"
#include "player/survey/survey.h"
#include "tests/player/test_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

const Vector3d up = Vector3d::UnitZ();

Measurement measurement(Measure measure, const std::vector<Vector3d>& points, double uncertainty = 0.01) {
    Measurement m{"", measure, {}};
    for (const Vector3d& p : points) m.points.push_back({p, uncertainty, ""});
    return m;
}
Measured measured(Measure measure, const std::vector<Vector3d>& points) {
    return evaluate(measurement(measure, points), {}, up);
}
double value(Measure measure, const std::vector<Vector3d>& points) {
    return measured(measure, points).value.value_or(-1);
}

/// Corners of a hexagon on a plane of arbitrary orientation, far from the origin.
std::vector<Vector3d> tilted_l_shape(const Vector3d& at) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    std::vector<Vector3d> out;
    for (const auto& [x, y] :
         {std::pair(0.0, 0.0), {3.0, 0.0}, {3.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}})
        out.push_back(at + R * Vector3d(x, y, 0));
    return out;
}

/// The standard deviation of a measurement whose points are randomly displaced by their uncertainties.
double spread(const Measurement& m, const Scale& scale) {
    std::mt19937 engine(5);
    std::normal_distribution<double> normal;
    const int trials = 20000;
    double sum = 0, squares = 0;
    for (int i = 0; i < trials; ++i) {
        Measurement moved = m;
        for (SurveyPoint& p : moved.points)
            for (const double by : {*p.uncertainty, p.pointing})
                p.position += by * Vector3d(normal(engine), normal(engine), normal(engine));
        Scale erring = scale;
        erring.length *= 1 + scale.relative * normal(engine);
        const double v = *evaluate(moved, erring, up).value;
        sum += v / trials, squares += v * v / trials;
    }
    return std::sqrt(squares - sum * sum);
}

}  // namespace

TEST(Measurement, HasTheValuesOfGeometry) {
    const Vector3d far(4.5e5, 5.4e6, 120);  // as in maps
    EXPECT_NEAR(value(Measure::distance, {far, far + Vector3d(3, 4, 12)}), 13, 1e-8);
    EXPECT_NEAR(value(Measure::profile, {far, far + Vector3d(3, 4, 12)}), 13, 1e-8);
    EXPECT_NEAR(value(Measure::polyline, {far, far + Vector3d(3, 4, 0), far + Vector3d(3, 4, 2)}), 7, 1e-8);
    EXPECT_NEAR(value(Measure::area, tilted_l_shape(far)), 4, 1e-7);
    EXPECT_NEAR(value(Measure::angle, {Vector3d(2, 0, 0), Vector3d(0, 0, 0), Vector3d(-1, 1, 0)}), 135,
                1e-12);
    EXPECT_NEAR(value(Measure::height, {far, far + Vector3d(5, 5, -2.5)}), -2.5, 1e-8);
    std::vector<Vector3d> reversed = tilted_l_shape({0, 0, 0});
    std::ranges::reverse(reversed);
    EXPECT_NEAR(value(Measure::area, reversed), 4, 1e-12);
}

TEST(Measurement, TakesTheAreaOnThePlaneThatFitsBest) {
    // A square whose corners are alternately 0.1 above and 0.1 below its plane.
    const std::vector<Vector3d> warped{{0, 0, 0.1}, {2, 0, -0.1}, {2, 2, 0.1}, {0, 2, -0.1}};
    const Measured m = measured(Measure::area, warped);
    EXPECT_NEAR(*m.value, 4, 1e-12);
    EXPECT_NE(m.note.find("0.100 units away"), std::string::npos) << m.note;
}

TEST(Measurement, StatesTheSpreadThatItsPointsGiveIt) {
    const Scale scale{0.5, Unit::m, Unit::cm, 0.002};
    std::vector<Measurement> all{measurement(Measure::distance, {{0, 0, 0}, {1, 2, 0.5}}),
                                 measurement(Measure::polyline, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 3}}),
                                 measurement(Measure::area, tilted_l_shape({1, 2, 3})),
                                 measurement(Measure::angle, {{2, 0, 0}, {0, 0, 0}, {-1, 1, 0}}),
                                 measurement(Measure::height, {{0, 0, 0}, {1, 2, 0.5}})};
    for (Measurement& m : all) {
        m.points.front().uncertainty = 0.03;  // not all alike
        m.points.back().pointing = 0.04;
        const double expected = spread(m, scale);
        EXPECT_NEAR(*evaluate(m, scale, up).uncertainty, expected, 0.05 * expected) << name_of(m.measure);
    }
}

TEST(Measurement, ConvertsLengthsAndAreas) {
    const auto square = tilted_l_shape({0, 0, 0});
    const Scale feet{1, Unit::ft, Unit::m};
    const Measured area = evaluate(measurement(Measure::area, square), feet, up);
    EXPECT_NEAR(*area.value, 4 * 0.3048 * 0.3048, 1e-12);
    EXPECT_STREQ(area.unit, "m²");
    const Measured length = evaluate(measurement(Measure::distance, {{0, 0, 0}, {1, 0, 0}}), feet, up);
    EXPECT_NEAR(*length.value, 0.3048, 1e-12);
    const Measured angle = evaluate(measurement(Measure::angle, {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}), feet, up);
    EXPECT_NEAR(*angle.value, 90, 1e-12);
    const auto scale = scale_from(2, 0.01, 300, Unit::cm);  // 2 units are 3 m
    ASSERT_TRUE(scale);
    EXPECT_NEAR(*evaluate(measurement(Measure::distance, {{0, 0, 0}, {4, 0, 0}}), *scale, up).value, 600,
                1e-9);
    EXPECT_NEAR(scale->relative, 0.005, 1e-12);
}

TEST(Measurement, TheDistanceThatSetsTheScaleIsAsCertainAsItsKnownLength) {
    const Measurement known = measurement(Measure::distance, {{0, 0, 0}, {2, 0, 0}}),
                      other = measurement(Measure::distance, {{0, 0, 0}, {0, 2, 0}});
    Scale scale = *scale_from(2, *evaluate(known, {}, up).uncertainty, 8.56, Unit::m);
    scale.between = {known.points[0].position, known.points[1].position};
    EXPECT_EQ(text_of(evaluate(known, scale, up)), "8.56 m") << "its points' errors are in the scale";
    EXPECT_EQ(text_of(evaluate(other, scale, up)), "8.560 ± 0.086 m") << "with its own error and the scale's";
}

TEST(Measurement, RefusesScalesThatAreNone) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [is, known] :
         {std::pair(0.0, 1.0), {1.0, 0.0}, {1.0, -1.0}, {none, 1.0}, {1.0, none}, {1e-300, 1e300}})
        EXPECT_FALSE(scale_from(is, 0, known, Unit::m)) << is << " " << known;
    EXPECT_FALSE(scale_from(1, 0, 1, Unit::unknown));
}

TEST(Measurement, HasNoValueRatherThanAWrongOne) {
    const Vector3d a(1, 2, 3), b(4, 5, 6), c(7, 8, 9);
    EXPECT_FALSE(measured(Measure::angle, {a, a, b}).value);
    EXPECT_FALSE(measured(Measure::distance, {a}).value);
    EXPECT_FALSE(measured(Measure::area, {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).value) << "crossed";
    EXPECT_FALSE(measured(Measure::distance, {Vector3d::Constant(-1e308), Vector3d::Constant(1e308)}).value);
    EXPECT_EQ(value(Measure::distance, {a, a}), 0);
    EXPECT_NEAR(value(Measure::area, {a, b, c}), 0, 1e-9) << "on a line";
    EXPECT_NEAR(value(Measure::area, {a, a, a}), 0, 1e-9);
    EXPECT_NEAR(value(Measure::angle, {a, b, c}), 180, 1e-5);
    EXPECT_NEAR(value(Measure::angle, {a, b, a}), 0, 1e-5);
}

TEST(Measurement, IsFiniteForEqualAndCollinearPoints) {
    Random random;
    for (int i = 0; i < 3000; ++i) {
        const auto measure = Measure(i % int(Measure::count));
        const Vector3d at = random.vector(10), along = random.vector(std::pow(10, random(-12, 3)));
        std::vector<Vector3d> points;
        while (points.size() < std::min<std::size_t>(max_points(measure), 5))
            points.push_back(at + along * std::floor(random(0, 3)));
        const Measured m = measured(measure, points);
        EXPECT_TRUE(!m.value || std::isfinite(*m.value)) << name_of(measure);
        EXPECT_TRUE(!m.uncertainty || (std::isfinite(*m.uncertainty) && *m.uncertainty >= 0))
            << name_of(measure);
    }
}

TEST(Measurement, IsWrittenWithTheDigitsThatItHas) {
    Measurement m = measurement(Measure::distance, {{0, 0, 0}, {2.0137, 0, 0}}, 0.0021);
    const Scale meters{1, Unit::m, Unit::m};
    EXPECT_EQ(text_of(evaluate(m, meters, up)), "2.0137 ± 0.0030 m");
    m.points.front().uncertainty.reset();
    EXPECT_EQ(text_of(evaluate(m, meters, up)), "2.0137 m");
    EXPECT_EQ(coordinates_text({{1.25, -3, 5412345.5}, 0.01, ""}), "x 1.250   y -3.000   z 5412345.500");
}

TEST(Measurement, NotesHaveTheDigitsOfTheValueAndNoNoise) {
    Measurement distance = measurement(Measure::distance, {{0, 0, 0}, {2.0137, 1e-17, -1e-17}}, 0.0021);
    EXPECT_EQ(evaluate(distance, {}, up).note, "along x 2.0137, y 0.0000, z 0.0000 units");
    distance.points.front().uncertainty.reset();
    EXPECT_EQ(evaluate(distance, {}, up).note, "along x 2.0137, y 0, z 0 units");
    Measurement height = measurement(Measure::height, {{0, 0, 0}, {1, 0, -1e-17}});
    EXPECT_EQ(text_of(evaluate(height, {}, up)), "0.000 ± 0.014 units");
    height.points.front().uncertainty.reset();
    EXPECT_EQ(text_of(evaluate(height, {}, up)), "0 units");
    EXPECT_NE(survey_csv({.measurements = {height}}).find("\"\",height,0,,"), std::string::npos);
    Measurement area = measurement(Measure::area, tilted_l_shape({1, 2, 3}));
    EXPECT_NE(evaluate(area, {}, up).note.find("up to 0.000 units away"), std::string::npos);
    area.points.front().uncertainty.reset();
    EXPECT_NE(evaluate(area, {}, up).note.find("up to 0 units away"), std::string::npos);
    EXPECT_EQ(coordinates_text({{1.25, -1e-17, 3}, {}, ""}), "x 1.25   y 0   z 3");
    EXPECT_EQ(direction_text(Vector3d(0.6, -1e-17, 0.8)), "0.6 0 0.8");
    EXPECT_EQ(value_text(-1.3e-17, {-1.3e-17, 2.5}), "0");
}
