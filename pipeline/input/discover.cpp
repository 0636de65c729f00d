#include "pipeline/input/discover.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "pipeline/formats/cameras.h"
#include "pipeline/formats/cloud.h"
#include "pipeline/formats/mesh.h"
#include "pipeline/formats/ply.h"
#include "pipeline/input/band_groups.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/photos/photos.h"
#include "scene/error.h"
#include "values/lower_extension.h"

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

/// Meshes, never files of --deviation-from or --points; those with nodes last, mesh.* before other names,
/// then the larger file.
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

/// Point clouds that are not given, the largest first.
Files find_clouds(const Files& files, const InputFiles& given) {
    Files found;
    for (const fs::path& f : files)
        if (is_cloud_file(f) && !is_given(f, given) && !(lower_extension(f) == ".ply" && has_faces(f)))
            found.push_back(f);
    std::ranges::stable_sort(found, std::greater{}, [](const fs::path& f) { return fs::file_size(f); });
    return found;
}

/// Without a mesh, takes the largest cloud, unless one is given; notes the clouds that are not used.
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

/// Without a mesh, cameras without photos and photos without cameras are not used.
void drop_unmatched(const fs::path& folder, InputFiles& found) {
    const auto note = [&](fs::path& file, const char* why) {
        const fs::path name = file.lexically_relative(folder);
        found.notes.push_back((name.empty() || name == "." ? file : name).string() + ": not used, " + why);
        file.clear();
    };
    if (found.cameras.empty() && !found.photos.empty()) note(found.photos, "no cameras found");
    if (found.photos.empty() && !found.cameras.empty()) note(found.cameras, "no photos found");
}

/// Whether `file` is the first file of a folder in this format; the others lie next to it.
bool is_first_of(const CameraFormat& format, const fs::path& file) {
    return !format.files.empty() && file.filename() == format.files.front() &&
           std::ranges::all_of(format.files,
                               [&](const char* name) { return fs::exists(file.parent_path() / name); });
}

/// The photos' names in a camera file.
std::vector<std::string> photo_names(const fs::path& cameras) {
    std::vector<std::string> names;
    for (const CameraSet::Entry& entry : read_cameras(cameras).entries) names.push_back(entry.photo);
    return names;
}

/// The camera files of the first format that has any.
Files camera_candidates(const Files& files) {
    Files found;
    for (const CameraFormat& format : camera_formats()) {
        for (const fs::path& f : files) {
            if (format.files.empty() && format.matches(f)) {
                const fs::path path = format.one_per_photo ? f.parent_path() : f;
                if (found.empty() || found.back() != path) found.push_back(path);
            }
            if (is_first_of(format, f)) found.push_back(f.parent_path());
        }
        if (!found.empty()) return found;
    }
    return found;
}

fs::path find_cameras(const fs::path& folder, const Files& files, std::vector<std::string>& notes) {
    const Files found = camera_candidates(files);
    if (found.size() < 2) return found.empty() ? fs::path() : found.front();
    std::vector<std::size_t> sizes;
    std::vector<std::string> flaws(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) try {
            sizes.push_back(photo_names(found[i]).size());
        } catch (const NoCamera& e) {  // a file of the format may hold other things, such as markers
            sizes.push_back(0);
            flaws[i] = reason_of(e, found[i]);
        }
    const auto most = std::size_t(std::ranges::max_element(sizes) - sizes.begin());
    for (std::size_t i = 0; i < found.size(); ++i)
        if (i != most)
            notes.push_back(found[i].lexically_relative(folder).string() + ": not used, " +
                            (flaws[i].empty() ? "has " + std::to_string(sizes[i]) + " cameras" : flaws[i]) +
                            "; " + found[most].lexically_relative(folder).string() + " has " +
                            std::to_string(sizes[most]));
    return found[most];
}

/// One camera file per band, each in the folder of its band, and the folder that holds them all; nothing if
/// the files are others.
struct CamerasOfBands {
    Files cameras;
    fs::path photos;
};
std::optional<CamerasOfBands> cameras_of_bands(const fs::path& root, const Files& files,
                                               const std::string& how) {
    CamerasOfBands out{camera_candidates(files), {}};
    std::set<fs::path> folders;
    for (const fs::path& cameras : out.cameras) {
        const fs::path folder = band_folder(root, cameras, how);
        const bool file_itself = folder == cameras && !fs::is_directory(cameras);
        if (folder.empty() || file_itself || !folders.insert(folder).second || photos_below(folder).empty())
            return {};
        out.photos = folder.parent_path();
    }
    const bool together = std::ranges::all_of(
        folders, [&](const fs::path& folder) { return folder.parent_path() == out.photos; });
    if (folders.size() < 2 || !together) return {};
    return out;
}

/// Cameras, and with one file of cameras per band the photos' folder, unless they are given.
void find_all_cameras(const fs::path& folder, const Files& files, InputFiles& found) {
    if (!found.cameras.empty()) return;
    const auto of_bands = found.photos.empty() && found.bands != bands_off
                              ? cameras_of_bands(folder, files, found.bands)
                              : std::nullopt;
    if (!of_bands) {
        found.cameras = find_cameras(folder, files, found.notes);
        return;
    }
    found.cameras = of_bands->cameras.front();
    found.more_cameras.assign(of_bands->cameras.begin() + 1, of_bands->cameras.end());
    found.photos = of_bands->photos;
}

/// Steps from one folder to another.
std::ptrdiff_t distance(const fs::path& from, const fs::path& to) {
    const fs::path steps = to.lexically_relative(from);
    return std::distance(steps.begin(), steps.end());
}

/// How well a folder's photos fit the cameras.
struct PhotoFolder {
    fs::path path;
    std::size_t matched = 0, by_name = 0, photos = 0;
    bool derived = false, named = false;
    std::ptrdiff_t from_cameras = 0;
    auto rank() const {
        return std::tuple(matched > 0 && !derived, matched, by_name, named, -from_cameras, photos);
    }
};

bool is_below(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

PhotoFolder rated(const fs::path& path, const fs::path& root, const fs::path& cameras,
                  const std::vector<std::string>& names) {
    PhotoFolder f{.path = path};
    const Files photos = photos_below(path);
    for (const PhotoMatch& m : match_photos(path, photos, names)) {
        f.matched += !m.file.empty();
        f.by_name += m.by_name;
    }
    f.photos = std::size_t(std::ranges::count(photos, path, &fs::path::parent_path));
    f.derived = std::ranges::any_of(path.lexically_relative(root), is_derived);
    f.named = is_one_of(path.filename().string(), {"images", "photos"});
    f.from_cameras = distance(cameras, path);
    return f;
}

fs::path find_photos(const fs::path& root, const Files& files, const fs::path& cameras) {
    std::set<fs::path> folders;
    for (const fs::path& f : files)
        if (is_photo(f)) folders.insert(f.parent_path());
    if (folders.size() < 2) return folders.empty() ? fs::path() : *folders.begin();
    for (const fs::path& f : std::set(folders))
        for (fs::path above = f; is_below(above, root) && above != root; folders.insert(above))
            above = above.parent_path();
    const std::vector<std::string> names =
        cameras.empty() ? std::vector<std::string>() : photo_names(cameras);
    const fs::path beside = fs::is_directory(cameras) ? cameras : cameras.parent_path();
    std::vector<PhotoFolder> all;
    for (const fs::path& f : folders) all.push_back(rated(f, root, beside, names));
    // A folder whose subfolder serves as many cameras is not the photos' own.
    std::vector<PhotoFolder> candidates;
    for (const PhotoFolder& f : all)
        if (std::ranges::none_of(all, [&](const PhotoFolder& below) {
                return below.path != f.path && is_below(below.path, f.path) && below.derived == f.derived &&
                       below.matched >= f.matched && below.photos > 0;
            }))
            candidates.push_back(f);
    return std::ranges::max_element(candidates, {}, &PhotoFolder::rank)->path;
}

/// The same folder without a slash at its end, as in the paths of its files.
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
                    folder.string() + ": has no mesh, of which --deviation-from could measure the deviation");
    if (!found.mesh.empty() && found.cameras.empty())
        throw Error(Exit::input, folder.string() + ": no cameras found; expected " + camera_format_names());
    if (!found.mesh.empty() && found.photos.empty())
        throw Error(Exit::input, folder.string() + ": no photos found");
}

}  // namespace

fs::path find_stencil(const fs::path& photo) {
    const fs::path folder = photo.parent_path(), above = folder.parent_path();
    for (const fs::path& name : {photo.filename(), photo.stem()})
        for (const fs::path& candidate :
             {folder / (name.string() + ".mask.png"),
              above.parent_path() / "masks" / folder.filename() / (name.string() + ".png"),
              above / "masks" / (name.string() + ".png")})
            if (std::error_code error; fs::is_regular_file(candidate, error)) return candidate;
    return {};
}

FoundInput search(const fs::path& given_folder, const InputFiles& given) {
    const fs::path folder = without_slash(given_folder);
    if (!fs::exists(folder)) throw Error(Exit::input, folder.string() + ": does not exist");
    if (!fs::is_directory(folder)) throw Error(Exit::input, folder.string() + ": not a folder");
    const Files files = files_below(folder, 2);
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
    attempt([&] { find_all_cameras(folder, files, found); });
    take_clouds(folder, files, found);
    if (found.photos.empty()) attempt([&] { found.photos = find_photos(folder, files, found.cameras); });
    if (found.mesh.empty() && !found.points.empty()) drop_unmatched(folder, found);
    if (const auto usd = std::ranges::find_if(files, is_usd_file);
        usd != files.end() && found.mesh.empty() && found.points.empty())
        attempt([&] { read_mesh_file(*usd); });  // says what to export instead
    attempt([&] { expect_complete(folder, found); });
    return out;
}

InputFiles discover(const fs::path& folder, const InputFiles& given) {
    const FoundInput found = search(folder, given);
    if (found.lacks) throw *found.lacks;
    return found.files;
}

}  // namespace vantage
