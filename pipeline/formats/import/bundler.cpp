#include <algorithm>

#include "pipeline/formats/import/cameras.h"
#include "pipeline/formats/import/conventions.h"
#include "pipeline/formats/import/tokens.h"

namespace vantage {
namespace {

/// The names of the photos, in the order of the cameras: the first word of each line of list.txt.
std::vector<std::string> photo_list(const std::filesystem::path& bundle) {
    const auto folder = bundle.parent_path();
    for (const std::filesystem::path& file :
         {folder / "list.txt", folder / (bundle.stem().string() + ".list.txt"),
          folder.parent_path() / "list.txt"}) {
        if (!std::filesystem::exists(file)) continue;
        Tokens in(file);
        std::vector<std::string> names;
        while (!in.at_end()) {
            names.emplace_back(in.word("a photo name"));
            in.line();
        }
        return names;
    }
    throw Error(Exit::input,
                bundle.string() + ": expected a list.txt with the photo names next to it, found none");
}

}  // namespace

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
            set.warnings.push_back(photo + ": not registered by Bundler; left out");
            continue;
        }
        c.intrinsics.fx = c.intrinsics.fy = f;
        c.cam_from_world = from_bundler(R, t);
        set.entries.push_back({photo, c, false});
    }
    return set;
}

}  // namespace vantage
