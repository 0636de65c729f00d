// Compares lens models with other implementations: with OpenCV where it has the model, otherwise with the
// equations in long double or their inverse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <random>
#include <vector>

#include "scene/camera/lens.h"

namespace vantage {
namespace {

using Real = long double;
using Coefficients = std::array<double, 12>;
constexpr double focal = 3000;  // pixels, of a frame of 4000 x 3000

/// Directions that are spread over the frame and lie within the lens's range.
std::vector<Eigen::Vector2d> directions(const Lens& lens) {
    const double range = lens_range(lens);
    std::vector<Eigen::Vector2d> out;
    for (int y = -20; y <= 20; ++y)
        for (int x = -20; x <= 20; ++x) {
            const Eigen::Vector2d q(x * 2000 / 20 / focal, y * 1500 / 20 / focal);
            if (q.norm() < 0.999 * range) out.push_back(q);
        }
    return out;
}

double worst(const Lens& lens, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& truth) {
    double most = 0;
    for (const Eigen::Vector2d& q : directions(lens))
        most = std::max(most, focal * (distort(lens, q) - truth(q)).norm());
    return most;
}

/// Realistic coefficients, with a distortion of several percent at the corner.
Coefficients coefficients(std::mt19937& random, std::initializer_list<double> sizes) {
    std::uniform_real_distribution<double> one(-1, 1);
    Coefficients p{};
    std::size_t i = 0;
    for (const double size : sizes) p[i++] = size * one(random);
    return p;
}

Eigen::Vector2d by_opencv(const Eigen::Vector2d& q, const std::vector<double>& k, bool fisheye) {
    const cv::Mat camera = cv::Mat::eye(3, 3, CV_64F), none = cv::Mat::zeros(3, 1, CV_64F);
    std::vector<cv::Point2d> image;
    if (fisheye)
        cv::fisheye::distortPoints(std::vector<cv::Point2d>{{q.x(), q.y()}}, image, camera, k);
    else
        cv::projectPoints(std::vector<cv::Point3d>{{q.x(), q.y(), 1}}, none, none, camera, k, image);
    return {image[0].x, image[0].y};
}

struct Ld {
    Real x, y;
    Real r2() const { return x * x + y * y; }
};
Ld times(const Ld& a, Real s) { return {a.x * s, a.y * s}; }
Eigen::Vector2d rounded(const Ld& a) { return {double(a.x), double(a.y)}; }

/// The position of a direction in the equidistant projection.
Ld equidistant(const Eigen::Vector2d& q) {
    const Ld a{q.x(), q.y()};
    const Real r = std::sqrt(a.r2());
    return r > 0 ? times(a, std::atan(r) / r) : a;
}

/// 1 + the sum of c[i] r^(2 i + 2).
Real radial(const std::vector<double>& c, Real r2) {
    Real out = 1, power = 1;
    for (const double v : c) out += Real(v) * (power *= r2);
    return out;
}

Ld tangential(const Ld& a, double p1, double p2) {
    return {2 * Real(p1) * a.x * a.y + Real(p2) * (a.r2() + 2 * a.x * a.x),
            Real(p1) * (a.r2() + 2 * a.y * a.y) + 2 * Real(p2) * a.x * a.y};
}

constexpr int trials = 50;

/// Expects errors below a millionth of a pixel, and records the largest error in a test.
class Exact {
  public:
    ~Exact() {
        ::testing::Test::RecordProperty("worst_pixels", (::testing::Message() << worst_).GetString());
    }
    void expect(double error) {
        EXPECT_LT(error, 1e-6);
        worst_ = std::max(worst_, error);
    }

  private:
    double worst_ = 0;
};

TEST(LensModels, RationalEqualsOpenCv) {
    Exact exact;
    std::mt19937 random(1);
    for (int i = 0; i < trials; ++i) {
        const Lens lens{LensModel::opencv,
                        coefficients(random, {0.2, 0.1, 0.002, 0.002, 0.05, 0.1, 0.05, 0.02})};
        const std::vector<double> k(lens.p.begin(), lens.p.begin() + 8);
        exact.expect(worst(lens, [&](const auto& q) { return by_opencv(q, k, false); }));
    }
}

TEST(LensModels, FisheyeEqualsOpenCv) {
    Exact exact;
    std::mt19937 random(2);
    for (int i = 0; i < trials; ++i) {
        const Lens lens{LensModel::fisheye, coefficients(random, {0.1, 0.05, 0.02, 0.01})};
        const std::vector<double> k(lens.p.begin(), lens.p.begin() + 4);
        exact.expect(worst(lens, [&](const auto& q) { return by_opencv(q, k, true); }));
    }
}

TEST(LensModels, FieldOfViewEqualsItsEquation) {
    Exact exact;
    for (const double omega : {1e-9, 0.01, 0.5, 0.9, 1.4}) {
        const auto truth = [&](const Eigen::Vector2d& q) {
            const Ld a{q.x(), q.y()};
            const Real r = std::sqrt(a.r2());
            if (r == 0) return q;
            return rounded(times(a, std::atan(2 * r * std::tan(Real(omega) / 2)) / (r * Real(omega))));
        };
        exact.expect(worst({LensModel::fov, {omega}}, truth));
    }
}

TEST(LensModels, ThinPrismEqualsItsEquation) {
    Exact exact;
    std::mt19937 random(3);
    for (int i = 0; i < trials; ++i) {
        const Coefficients p = coefficients(random, {0.1, 0.05, 0.002, 0.002, 0.02, 0.01, 0.002, 0.002});
        const auto truth = [&](const Eigen::Vector2d& q) {
            const Ld e = equidistant(q), t = tangential(e, p[2], p[3]);
            const Ld d = times(e, radial({p[0], p[1], p[4], p[5]}, e.r2()));
            return rounded({d.x + t.x + Real(p[6]) * e.r2(), d.y + t.y + Real(p[7]) * e.r2()});
        };
        exact.expect(worst({LensModel::thin_prism, p}, truth));
    }
}

TEST(LensModels, BrownWithSkewEqualsItsEquation) {
    Exact exact;
    std::mt19937 random(4);
    for (int i = 0; i < trials; ++i) {
        const Coefficients p = coefficients(random, {0.2, 0.1, 0.002, 0.002, 0.05, 0.02, 0.01});
        const auto truth = [&](const Eigen::Vector2d& q) {
            const Ld a{q.x(), q.y()}, t = tangential(a, p[2], p[3]);
            const Ld d = times(a, radial({p[0], p[1], p[4], p[5]}, a.r2()));
            return rounded({d.x + t.x + Real(p[6]) * (d.y + t.y), d.y + t.y});
        };
        exact.expect(worst({LensModel::brown, p}, truth));
    }
}

TEST(LensModels, AriaEqualsItsEquation) {
    Exact exact;
    std::mt19937 random(5);
    for (int i = 0; i < trials; ++i) {
        const Coefficients p = coefficients(
            random, {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.002, 0.002, 0.002, 0.001, 0.002, 0.001});
        const auto truth = [&](const Eigen::Vector2d& q) {
            const Ld e = equidistant(q), d = times(e, radial({p[0], p[1], p[2], p[3], p[4], p[5]}, e.r2()));
            // The model's p0 and p1 are OpenCV's p2 and p1.
            const Ld t = tangential(d, p[7], p[6]);
            const Real r2 = d.r2();
            return rounded({d.x + t.x + Real(p[8]) * r2 + Real(p[9]) * r2 * r2,
                            d.y + t.y + Real(p[10]) * r2 + Real(p[11]) * r2 * r2});
        };
        exact.expect(worst({LensModel::aria, p}, truth));
    }
}

TEST(LensModels, UnifiedEqualsItsEquation) {
    Exact exact;
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < trials; ++i) {
        const double alpha = share(random), beta = 0.5 + share(random);
        const auto truth = [&](const Eigen::Vector2d& q) {
            const Ld a{q.x(), q.y()};
            const Real rho = std::sqrt(Real(beta) * a.r2() + 1);
            return rounded(times(a, 1 / (Real(alpha) * rho + (1 - Real(alpha)))));
        };
        exact.expect(worst({LensModel::unified, {alpha, beta}}, truth));
    }
}

/// The largest error, in pixels, when directions are distorted and undistorted again.
double worst_return(const Lens& lens, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& back) {
    double most = 0;
    for (const Eigen::Vector2d& q : directions(lens))
        most = std::max(most, focal * (back(distort(lens, q)) - q).norm());
    return most;
}

TEST(LensModels, DivisionComesBackByItsEquation) {
    Exact exact;
    for (const double k : {-0.5, -0.1, -1e-7, 0.0, 1e-7, 0.1, 0.4}) {
        const auto back = [&](const Eigen::Vector2d& d) {
            return Eigen::Vector2d(d / (1 + k * d.squaredNorm()));
        };
        exact.expect(worst_return({LensModel::division, {k}}, back));
    }
}

TEST(LensModels, MatchMoverComesBackByItsEquation) {
    Exact exact;
    for (const double k : {-0.3, -0.09, -1e-7, -1e-18, 0.0, 1e-18, 1e-7, 0.05, 0.3}) {
        const auto back = [&](const Eigen::Vector2d& d) {
            return Eigen::Vector2d(d * (1 + k * d.squaredNorm()));
        };
        exact.expect(worst_return({LensModel::matchmover, {k}}, back));
    }
}

TEST(LensModels, RangeEndsWhereAModelHasNoImage) {
    // The radius in the photo folds back at 1 / sqrt(k), and x' + k x'^3 folds back at 1 / sqrt(-3 k).
    EXPECT_NEAR(lens_range({LensModel::division, {0.25}}), 1, 1e-3);
    EXPECT_TRUE(std::isinf(lens_range({LensModel::division, {-0.25}})));
    EXPECT_NEAR(lens_range({LensModel::matchmover, {-1.0 / 3}}), 2.0 / 3, 1e-3);
    EXPECT_TRUE(std::isinf(lens_range({LensModel::matchmover, {0.3}})));
    EXPECT_TRUE(std::isinf(lens_range({LensModel::unified, {0.6, 1.1}})));
    EXPECT_LT(lens_range({LensModel::brown, {0, 0, 0, 0, 0, -0.2}}), std::pow(1 / (9 * 0.2), 1.0 / 8) + 1e-3);
}

}  // namespace
}  // namespace vantage
