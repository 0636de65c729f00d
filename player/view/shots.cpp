#include "player/view/shots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "scene/package/contents/image_sets.h"

namespace vantage {

constexpr double max_seconds = 1e6;  ///< of a flight

FrameSize parse_size(const std::string& text) {
    FrameSize s;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &s.width, &s.height, &rest) != 2 || s.width < 1 || s.height < 1)
        throw Error(Exit::usage, "--size " + text + ": expected WIDTHxHEIGHT in pixels, such as 1280x720");
    return s;
}

std::vector<std::uint32_t> named_photos(const PackageReader& package, const std::vector<std::string>& names) {
    const auto count = std::uint32_t(package.photos().size());
    std::vector<std::uint32_t> out;
    const auto add = [&](std::uint32_t photo) {
        if (!std::ranges::count(out, photo)) out.push_back(photo);
    };
    for (const std::string& name : names) {
        if (const auto i = package.photo_index(name)) {
            add(*i);
        } else if (name == "all") {
            for (std::uint32_t p = 0; p < count; ++p) add(p);
        } else {
            throw Error(Exit::usage, name + ": " + package.path().string() +
                                         " has no such photo ('vantage-player list' lists them)");
        }
    }
    return out;
}

Shot photo_shot(const package::PhotoRecord& photo, const std::string& name, std::optional<FrameSize> size,
                double scale) {
    Shot shot{name, view_of_photo(photo, scale), photo.image_set, {}, seen_distance(photo)};
    if (!size) return shot;
    Intrinsics k = intrinsics(photo);
    const double s = std::min(double(size->width) / k.width, double(size->height) / k.height);
    const double left = (size->width - k.width * s) / 2, top = (size->height - k.height * s) / 2;
    shot.view.intrinsics = {size->width, size->height, k.fx * s, k.fy * s, k.cx * s + left, k.cy * s + top};
    return shot;
}

namespace {

/// The numbers of a view in the format of parse_view(), with the field of view and the roll.
std::array<double, 8> view_numbers(const std::string& text) {
    std::string spaced = text;
    std::replace(spaced.begin(), spaced.end(), ',', ' ');
    std::istringstream in(spaced);
    std::vector<double> v;
    for (double x; in >> x;) v.push_back(x);
    if (!in.eof() || v.size() < 6 || v.size() > 8 ||
        !std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); }))
        throw Error(
            Exit::usage,
            "view '" + text + "': expected EX,EY,EZ,TX,TY,TZ and optionally a field of view and a roll");
    const double fov = v.size() > 6 ? v[6] : 45, roll = v.size() > 7 ? v[7] : 0;
    if (!(fov > 0.01 && fov < 179))
        throw Error(Exit::usage, "view '" + text + "': the field of view must be 0.01 to 179 degrees");
    if (!(std::abs(roll) <= 360))
        throw Error(Exit::usage, "view '" + text + "': the roll must be -360 to 360 degrees");
    return {v[0], v[1], v[2], v[3], v[4], v[5], fov, roll};
}

/// Parses and removes "image-set=NAME" at the end of a line.
std::optional<std::uint32_t> take_image_set(std::string& line, const PackageReader& package) {
    constexpr std::string_view key = "image-set=";
    const std::size_t at = line.find(key);
    if (at == std::string::npos) return {};
    std::string name = line.substr(at + key.size());
    name.erase(name.find_last_not_of(" \t\r") + 1);
    line.erase(at);
    return image_set_named(package, name);
}

/// Parses and removes "at=SECONDS" at the end of a line; the time must not be less than `earliest`.
std::optional<double> take_time(std::string& line, double earliest) {
    const std::size_t at = line.find("at=");
    if (at == std::string::npos) return {};
    std::istringstream in(line.substr(at + 3));
    double seconds = 0;
    std::string rest;
    if (!(in >> seconds) || in >> rest || !(seconds >= earliest && seconds <= max_seconds))
        throw Error(Exit::usage,
                    "'" + line.substr(at) + "': expected at=SECONDS, not earlier than in the line above");
    line.erase(at);
    return seconds;
}

}  // namespace

View parse_view(const std::string& text, const PackageReader& package, FrameSize size) {
    return parse_view_and_distance(text, package, size).first;
}

std::pair<View, double> parse_view_and_distance(const std::string& text, const PackageReader& package,
                                                FrameSize size) {
    const std::array<double, 8> v = view_numbers(text);
    const Eigen::Vector3d eye(v[0], v[1], v[2]), target(v[3], v[4], v[5]);
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    View view =
        view_towards(eye - origin, target - origin, up_of(package.scene()), v[6], size.width, size.height);
    view.cam_from_origin.R = rolled(view.cam_from_origin.R, v[7]);
    view.cam_from_origin.t = -view.cam_from_origin.R * (eye - origin);
    return {view, (target - eye).norm()};
}

std::vector<Shot> read_path(const std::string& file, const PackageReader& package, FrameSize size) {
    std::ifstream in(file);
    if (!in) throw Error(Exit::input, file + ": cannot be read");
    std::vector<Shot> shots;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // byte order mark
        if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
        const std::string name = formatted("%04zu", shots.size());
        try {
            const std::optional<std::uint32_t> image_set = take_image_set(line, package);
            const std::optional<double> at = take_time(line, shots.empty() ? 0 : shots.back().at.value_or(0));
            if (!shots.empty() && at.has_value() != shots.back().at.has_value())
                throw Error(Exit::usage, "expected at=SECONDS for every view or for none");
            const auto [view, distance] = parse_view_and_distance(line, package, size);
            shots.push_back({name, view, image_set, at, distance});
        } catch (const Error& e) {
            throw Error(Exit::input, file + ":" + std::to_string(number) + ": " + e.what());
        }
    }
    if (shots.empty()) throw Error(Exit::input, file + ": contains no view");
    return shots;
}

}  // namespace vantage
