#include "pipeline/input/discover.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <span>
#include <tuple>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/cloud.h"
#include "pipeline/formats/meshes/ply.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/find_cameras.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/run/files_below.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<fs::path>;

bool is_one_of(const std::string& text, std::initializer_list<const char*> list) {
    return std::any_of(list.begin(), list.end(), [&](const char* s) { return text == s; });
}

bool has_faces(const fs::path& mesh) { return lower_extension(mesh) != ".ply" || ply_has_faces(mesh); }

bool is_same(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a, b, error);
}

bool is_given(const fs::path& file, const InputFiles& given) {
    const auto is_file = [&](const fs::path& other) { return is_same(other, file); };
    return std::ranges::any_of(given.compared, is_file) || std::ranges::any_of(given.points, is_file);
}

/// The preferred mesh, which is never a file of --deviation-from or --points: formats with nodes come last,
/// mesh.* comes before other names, then larger files come first.
fs::path find_mesh(const Files& files, const InputFiles& given) {
    using Rank = std::tuple<bool, bool, std::uintmax_t>;
    fs::path best;
    Rank best_rank;
    for (const fs::path& f : files) {
        if (!is_mesh_file(f) || is_given(f, given) || !has_faces(f)) continue;
        const Rank rank{!has_nodes(f), f.stem() == "mesh", fs::file_size(f)};
        if (best.empty() || rank > best_rank) best = f, best_rank = rank;
    }
    return best;
}

/// Point clouds other than the given ones, largest first.
Files find_clouds(const Files& files, const InputFiles& given) {
    Files found;
    for (const fs::path& f : files)
        if (is_cloud_file(f) && !is_given(f, given) && !(lower_extension(f) == ".ply" && has_faces(f)))
            found.push_back(f);
    std::ranges::stable_sort(found, std::greater{}, [](const fs::path& f) { return fs::file_size(f); });
    return found;
}

/// Without a mesh, takes the largest cloud unless one is given. Notes the unused clouds.
void take_clouds(const fs::path& folder, const Files& files, InputFiles& found) {
    const bool takes = found.mesh.empty() && found.points.empty();
    const Files clouds = find_clouds(files, found);
    for (std::size_t i = 0; i < clouds.size(); ++i) {
        const std::string name = clouds[i].lexically_relative(folder).string();
        if (takes && i == 0)
            found.points.push_back(clouds[i]);
        else
            found.notes.push_back(name + ": a point cloud, not used; --points shows it");
    }
}

/// Without a mesh, drops cameras without photos and photos without cameras.
void drop_unmatched(const fs::path& folder, InputFiles& found) {
    const auto note = [&](fs::path& file, const char* why) {
        const fs::path name = file.lexically_relative(folder);
        found.notes.push_back((name.empty() || name == "." ? file : name).string() + ": not used, " + why);
        file.clear();
    };
    if (found.cameras.empty() && !found.photos.empty()) note(found.photos, "no cameras found");
    if (found.photos.empty() && !found.cameras.empty()) note(found.cameras, "no photos found");
}

/// The fit of a folder's photos to the cameras.
struct PhotoFolder {
    fs::path path;
    std::size_t matched = 0, folders = 0, by_name = 0, photos = 0;
    bool derived = false, named = false;
    std::ptrdiff_t from_cameras = 0;
    /// A rank by the fit of the files and by whether the folder has a typical name.
    auto fit() const { return std::tuple(matched > 0 && !derived, matched, folders, by_name, named); }
    auto rank() const { return std::tuple_cat(fit(), std::tuple(-from_cameras, photos)); }
};

bool is_below(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

PhotoFolder rated(const fs::path& path, const fs::path& root, const fs::path& camera_folder,
                  std::span<const CameraSet::Entry> cameras) {
    PhotoFolder f{.path = path};
    const Files photos = photos_below(path);
    std::set<fs::path> matched;
    for (const PhotoMatch& m : match_photos(path, photos, cameras)) {
        if (!m.file.empty()) matched.insert(m.file);
        f.matched += !m.candidates.empty();
        f.by_name += m.by_name;
        f.folders += m.folders;
    }
    f.matched += matched.size();
    f.photos = std::size_t(std::ranges::count(photos, path, &fs::path::parent_path));
    f.derived = std::ranges::any_of(path.lexically_relative(root), is_derived);
    f.named = is_one_of(path.filename().string(), {"images", "photos"});
    f.from_cameras = distance(camera_folder, path);
    return f;
}

/// Finds the photos' folder, and notes other folders that fit equally well.
fs::path find_photos(const fs::path& root, const Files& files, const fs::path& cameras,
                     std::vector<std::string>& notes) {
    std::set<fs::path> folders;
    for (const fs::path& f : files)
        if (is_photo(f)) folders.insert(f.parent_path());
    if (folders.size() < 2) return folders.empty() ? fs::path() : *folders.begin();
    for (const fs::path& f : std::set(folders))
        for (fs::path above = f; is_below(above, root) && above != root; folders.insert(above))
            above = above.parent_path();
    const std::vector<CameraSet::Entry> entries =
        cameras.empty() ? std::vector<CameraSet::Entry>() : read_cameras(cameras).entries;
    const fs::path beside = fs::is_directory(cameras) ? cameras : cameras.parent_path();
    std::vector<PhotoFolder> all;
    for (const fs::path& f : folders) all.push_back(rated(f, root, beside, entries));
    // If a subfolder matches as many cameras as its parent, the subfolder is the photos' folder.
    std::vector<PhotoFolder> candidates;
    for (const PhotoFolder& f : all)
        if (std::ranges::none_of(all, [&](const PhotoFolder& below) {
                return below.path != f.path && is_below(below.path, f.path) && below.derived == f.derived &&
                       below.matched >= f.matched && below.photos > 0;
            }))
            candidates.push_back(f);
    const PhotoFolder& best = *std::ranges::max_element(candidates, {}, &PhotoFolder::rank);
    const auto in_root = [&](const PhotoFolder& f) { return f.path.lexically_relative(root).string(); };
    for (const PhotoFolder& f : candidates)
        if (f.matched > 0 && f.fit() == best.fit() && !is_same(f.path, best.path) &&
            !is_below(f.path, best.path) && !is_below(best.path, f.path))
            notes.push_back(in_root(f) + ": fits the cameras as well as " + in_root(best) +
                            ", which is used; --photos selects another");
    return best.path;
}

/// The folder without a trailing slash, as in the paths of its files.
fs::path without_slash(const fs::path& folder) {
    return folder.has_filename() || folder.empty() ? folder : folder.parent_path();
}

void expect_complete(const fs::path& folder, const InputFiles& found) {
    if (found.mesh.empty() && found.points.empty())
        throw Error(Exit::input,
                    folder.string() + ": no mesh found (" + mesh_format_names + "), and no point cloud" +
                        (found.compared.empty() ? "" : " other than the files of --deviation-from"));
    if (found.mesh.empty() && !found.compared.empty())
        throw Error(Exit::usage,
                    folder.string() + ": has no mesh whose deviation --deviation-from could measure");
    if (!found.mesh.empty() && found.cameras.empty())
        throw Error(Exit::input, folder.string() + ": no cameras found; expected " + camera_format_names());
    if (!found.mesh.empty() && found.photos.empty())
        throw Error(Exit::input, folder.string() + ": no photos found");
}

}  // namespace

FoundInput search(const fs::path& given_folder, const InputFiles& given) {
    const fs::path folder = without_slash(given_folder);
    if (!fs::exists(folder)) throw Error(Exit::input, folder.string() + ": does not exist");
    if (!fs::is_directory(folder)) throw Error(Exit::input, folder.string() + ": not a folder");
    const Files deep = files_below(folder, given.photos.empty() ? 3 : 2);  // photos may be one level deeper
    Files files;
    std::ranges::copy_if(deep, std::back_inserter(files),
                         [&](const fs::path& file) { return distance(folder, file) <= 3; });
    FoundInput out{given, {}};
    InputFiles& found = out.files;
    for (fs::path* path : {&found.cameras, &found.photos}) *path = without_slash(*path);
    const auto attempt = [&](const auto& step) {
        try {
            step();
        } catch (const Error& e) {
            if (!out.lacks) out.lacks = e;
        }
    };
    if (found.mesh.empty()) found.mesh = find_mesh(files, found);
    attempt([&] { find_cameras(folder, files, found); });
    take_clouds(folder, files, found);
    if (found.photos.empty())
        attempt([&] { found.photos = find_photos(folder, deep, found.cameras, found.notes); });
    if (found.mesh.empty() && !found.points.empty()) drop_unmatched(folder, found);
    if (const auto usd = std::ranges::find_if(files, is_usd_file);
        usd != files.end() && found.mesh.empty() && found.points.empty())
        attempt([&] { read_mesh_file(*usd); });  // its error suggests another format
    attempt([&] { expect_complete(folder, found); });
    return out;
}

InputFiles discover(const fs::path& folder, const InputFiles& given) {
    const FoundInput found = search(folder, given);
    if (found.lacks) throw *found.lacks;
    return found.files;
}

}  // namespace vantage
