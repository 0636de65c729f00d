#include <algorithm>

#include "pipeline/formats/camera_axes.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/tokens.h"

namespace vantage {
namespace {

/// Removes the last word of a line and returns it; empty if there is none.
std::string_view take_last_word(std::string_view& line) {
    const std::size_t end = line.find_last_not_of(" \t");
    line = line.substr(0, end == line.npos ? 0 : end + 1);
    const std::size_t blank = line.find_last_of(" \t");
    const std::string_view word = line.substr(blank == line.npos ? 0 : blank + 1);
    line.remove_suffix(word.size());
    return word;
}

/// The name in a line of list.txt. The line is "NAME", or "NAME 0 FOCAL" with the focal length in pixels. The
/// name may contain blanks and be quoted.
std::string photo_name(std::string_view line) {
    std::string_view rest = line;
    double number = 0;
    if (parse_number(take_last_word(rest), number) && take_last_word(rest) == "0" &&
        rest.find_first_not_of(" \t") != rest.npos)
        line = rest;
    line = line.substr(0, line.find_last_not_of(" \t") + 1);
    if (line.size() > 2 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    return std::string(line);
}

/// The names of the photos, in the order of the cameras.
std::vector<std::string> photo_list(const std::filesystem::path& bundle) {
    const std::filesystem::path file = bundler_list(bundle);
    if (file.empty())
        throw Error(Exit::input,
                    bundle.string() + ": expected a list.txt with the photo names next to it, found none");
    Tokens in(file);
    std::vector<std::string> names;
    while (!in.at_end()) names.push_back(photo_name(in.line()));
    return names;
}

}  // namespace

std::filesystem::path bundler_list(const std::filesystem::path& bundle) {
    const auto folder = bundle.parent_path();
    for (const std::filesystem::path& file :
         {folder / "list.txt", folder / (bundle.stem().string() + ".list.txt"),
          folder.parent_path() / "list.txt"})
        if (std::filesystem::exists(file)) return file;
    return {};
}

CameraSet read_bundler(const std::filesystem::path& file) {
    CameraSet set{"Bundler", {}, {}};
    const std::vector<std::string> names = photo_list(file);
    Tokens in(file);
    while (in.skip_comment()) {
    }
    const auto cameras = in.number<std::size_t>("the number of cameras");
    in.number<std::size_t>("the number of points");
    if (cameras != names.size())
        throw Error(Exit::input, file.string() + ": has " + std::to_string(cameras) +
                                     " cameras, but its list has " + std::to_string(names.size()) +
                                     " photo names");
    for (const std::string& photo : names) {
        Camera c;
        const double f = in.number<double>("a focal length");
        c.lens.p[0] = in.number<double>("k1");
        c.lens.p[1] = in.number<double>("k2");
        if (c.lens.p[0] != 0 || c.lens.p[1] != 0) c.lens.model = LensModel::opencv;
        Eigen::Matrix3d R;
        Eigen::Vector3d t;
        for (int i = 0; i < 9; ++i) R(i / 3, i % 3) = in.number<double>("a rotation");
        for (double& v : t) v = in.number<double>("a translation");
        if (f == 0) {
            set.warnings.push_back(photo + ": not registered by Bundler; skipped");
            continue;
        }
        c.intrinsics.fx = c.intrinsics.fy = f;
        c.cam_from_world = from_bundler(R, t);
        set.entries.push_back({photo, c, CameraSet::Unit::pixels_from_center});
    }
    if (set.entries.empty())
        throw NoCamera(file.string() + ": expected a camera with a focal length above 0, found none");
    return set;
}

}  // namespace vantage
