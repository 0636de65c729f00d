#include "player/view/camera_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "player/view/shots.h"

namespace vantage {
namespace {

using std::numbers::pi;

/// A slowly varying random value in [-1, 1]: the mean of three sine waves.
class Waves {
  public:
    explicit Waves(std::mt19937& random) {
        for (Wave& w : waves_) {
            w.phase = std::uniform_real_distribution<double>(0, 2 * pi)(random);
            w.pace = std::uniform_real_distribution<double>(0.3, 1.6)(random);
        }
    }
    double at(double t) const {
        double sum = 0;
        for (const Wave& w : waves_) sum += std::sin(w.phase + w.pace * t);
        return sum / double(std::size(waves_));
    }

  private:
    struct Wave {
        double phase, pace;
    };
    Wave waves_[3];
};

}  // namespace

CameraPath scripted_path(const std::string& name, const Navigation& start, int frames, unsigned seed) {
    CameraPath path{name, {}};
    std::mt19937 random(seed);
    const Waves right(random), down(random), near(random), aside(random);
    for (int i = 0; i < frames; ++i) {
        const double share = double(i) / std::max(1, frames - 1);
        Navigation n = start;
        if (name == "orbit") {
            orbit(n, pi / 3 * std::sin(2 * pi * share), 0);
        } else if (name == "approach") {
            approach(n, 1 - 2.0 / 3 * std::sin(pi * share));
        } else if (name == "jump") {
            if (i < frames / 2) look(n, pi, 0);
        } else if (name == "flight") {
            const double t = i / 30.0;
            look(n, 0.5 * aside.at(t), 0);
            orbit(n, 1.2 * right.at(t), 0.4 * down.at(t));
            approach(n, std::exp2(1.2 * near.at(t) - 0.4));
        } else if (name != "still") {
            throw Error(
                Exit::usage,
                "path '" + name + "': expected still, orbit, approach, jump, flight or a file of views");
        }
        path.frames.push_back(n);
    }
    return path;
}

Navigation between(const Navigation& a, const Navigation& b, double share) {
    Navigation n = b;
    n.eye = a.eye + share * (b.eye - a.eye);
    n.target = a.target + share * (b.target - a.target);
    n.fov = a.fov + share * (b.fov - a.fov);
    n.aspect = a.aspect + share * (b.aspect - a.aspect);
    n.R = Eigen::Quaterniond(a.R).slerp(share, Eigen::Quaterniond(b.R)).toRotationMatrix();
    return n;
}

std::vector<Navigation> recorded_stops(const std::string& file, const PackageReader& package,
                                       double distance) {
    std::vector<Navigation> stops;
    const Eigen::Vector3d up = up_of(package.scene());
    for (const Shot& shot : read_path(file, package, {1280, 720}))
        stops.push_back(stand_at(shot.view, up, distance));
    return stops;
}

std::vector<KeyView> path_keys(const std::string& file, const PackageReader& package, double seconds) {
    std::vector<KeyView> keys;
    const Eigen::Vector3d up = up_of(package.scene());
    for (const Shot& shot : read_path(file, package, {1280, 720}))
        keys.push_back(
            {stand_at(shot.view, up, shot.distance), shot.at.value_or(double(keys.size()) * seconds)});
    return keys;
}

CameraPath recorded_path(const std::string& file, const PackageReader& package, int frames) {
    const std::vector<Navigation> stops = recorded_stops(file, package);
    CameraPath path{std::filesystem::path(file).stem().string(), {}};
    for (int i = 0; i < frames; ++i) {
        const double at = double(i) / std::max(1, frames - 1) * double(stops.size() - 1);
        const auto first = std::min(std::size_t(at), stops.size() - 1);
        path.frames.push_back(
            between(stops[first], stops[std::min(first + 1, stops.size() - 1)], at - double(first)));
    }
    return path;
}

std::vector<Navigation> photo_stops(const PackageReader& package, std::span<const std::uint32_t> photos) {
    const Eigen::Vector3d up = up_of(package.scene());
    std::vector<Navigation> stops;
    for (const std::uint32_t p : photos)
        if (package.photos()[p].levels > 0) stops.push_back(stand_at(package.photos()[p], up));
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const auto from = [&](const Navigation& n) { return (n.eye - stops[i - 1].eye).norm(); };
        std::iter_swap(stops.begin() + std::ptrdiff_t(i),
                       std::ranges::min_element(stops.begin() + std::ptrdiff_t(i), stops.end(), {}, from));
    }
    return stops;
}

std::vector<Navigation> in_steps(const std::vector<Navigation>& stops, double step) {
    constexpr double most = 1e6;
    std::vector<Navigation> frames;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const Navigation &a = stops[i], &b = stops[i + 1];
        const double distance = std::min((a.target - a.eye).norm(), (b.target - b.eye).norm());
        const double length =
            std::max((b.eye - a.eye).norm() / distance, Eigen::AngleAxisd(b.R * a.R.transpose()).angle());
        const double count = std::max(1.0, std::ceil(length / step));
        if (!(double(frames.size()) + count < most))
            throw Error(Exit::usage, "the path has more than a million frames, expected larger steps");
        for (double k = 0; k < count; ++k) frames.push_back(between(a, b, k / count));
    }
    if (!stops.empty()) frames.push_back(stops.back());
    return frames;
}

namespace {

/// The roll as an additional number after `separator`; empty if it is 0.
std::string roll_text(const Navigation& n, const char* separator) {
    const double roll = std::round(roll_of(n.R, n.up) * 1e4) / 1e4;
    return roll == 0 ? "" : separator + formatted("%.7g", roll);
}

}  // namespace

std::string view_text(const Navigation& n, const PackageReader& package) {
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    const Eigen::Vector3d e = n.eye + origin, t = n.target + origin;
    return formatted("%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.6g", e.x(), e.y(), e.z(), t.x(), t.y(), t.z(),
                     n.fov) +
           roll_text(n, ",");
}

void write_path(const std::filesystem::path& file, const std::vector<Navigation>& positions,
                const PackageReader& package, std::span<const std::string> image_sets,
                std::optional<double> per_second) {
    std::ostringstream out;
    out << "# EX EY EZ TX TY TZ, vertical field of view and roll in degrees\n";
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Navigation& n = positions[i];
        const Eigen::Vector3d e = n.eye + origin, t = n.target + origin;
        out << formatted("%.9g %.9g %.9g  %.9g %.9g %.9g  %.4g", e.x(), e.y(), e.z(), t.x(), t.y(), t.z(),
                         n.fov)
            << roll_text(n, "  ");
        if (per_second) out << "  at=" << double(i) / *per_second;
        out << (i < image_sets.size() ? "  image-set=" + image_sets[i] : "") << '\n';
    }
    replace_file(file, out.view());
}

}  // namespace vantage
