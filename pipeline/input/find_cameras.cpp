#include "pipeline/input/find_cameras.h"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/image_set_groups.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/photos/photos.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<fs::path>;

/// Whether `file` is the first file of a folder in this format; the others lie next to it.
bool is_first_of(const CameraFormat& format, const fs::path& file) {
    return !format.files.empty() && file.filename() == format.files.front() &&
           std::ranges::all_of(format.files,
                               [&](const char* name) { return fs::exists(file.parent_path() / name); });
}

/// The files, or folders of files, in a format.
struct FormatFiles {
    const CameraFormat* format;
    Files files;  ///< at least one
};
std::vector<FormatFiles> files_by_format(const Files& files) {
    std::vector<FormatFiles> out;
    for (const CameraFormat& format : camera_formats()) {
        std::set<fs::path> found;
        for (const fs::path& f : files) {
            if (format.files.empty() && format.matches(f))
                found.insert(format.one_per_photo ? f.parent_path() : f);
            if (is_first_of(format, f)) found.insert(f.parent_path());
        }
        if (!found.empty()) out.push_back({&format, {found.begin(), found.end()}});
    }
    return out;
}

/// The deepest folder that contains both paths.
fs::path common_folder(const fs::path& a, const fs::path& b) {
    fs::path out;
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end() && *i == *j; ++i, ++j) out /= *i;
    return out;
}

/// A camera file and its fit to the photos.
struct CameraChoice {
    fs::path path;
    const CameraFormat* format = nullptr;
    std::ptrdiff_t steps = 0, cameras = 0, matched = 0;
    std::string flaw = {};  ///< the reason why it has no cameras
    /// Among files that match equally many photos, the one with fewer other cameras is preferred, then nearer
    /// files and shorter names, because copies are farther away or have longer names.
    auto rank() const {
        return std::tuple(matched, matched ? -cameras : cameras, -steps, -std::ssize(path.native()));
    }
};

/// All camera files, by format, with their distance from the folder `near`. Copies are usually farther from
/// it.
std::vector<CameraChoice> choices(std::span<const FormatFiles> all, const fs::path& near) {
    std::vector<CameraChoice> out;
    for (auto [format, files] : all) {
        if (format->one_per_photo && files.size() > 1)
            files.push_back(common_folder(files.front(), files.back()));  // they are sorted
        for (const fs::path& path : files)
            if (std::ranges::count(out, path, &CameraChoice::path) == 0)
                out.push_back({path, format, distance(near, path)});
    }
    return out;
}

/// Reads the file and counts the photos that fit. Photos that fit a name equally well count as one.
void rate(CameraChoice& file, const fs::path& folder, const Files& photos) {
    try {
        const std::vector<CameraSet::Entry> cameras = read_cameras(file.path).entries;
        file.cameras = std::ssize(cameras);
        for (const PhotoMatch& m : match_photos(folder, photos, cameras))
            file.matched += !m.file.empty() || !m.candidates.empty();
    } catch (const NoCamera& e) {  // a file of the format may hold other data, such as markers
        file.flaw = reason_of(e, file.path);
    }
}

/// Reads files until one has a camera for every photo. Returns the best; if files of several formats are
/// equally good, the one whose format comes first.
const CameraChoice& best_of(std::vector<CameraChoice>& all, const fs::path& folder, const Files& photos) {
    const CameraChoice* best = nullptr;
    for (auto of_format = all.begin(); of_format != all.end();) {
        const auto end = std::find_if(of_format, all.end(),
                                      [&](const CameraChoice& f) { return f.format != of_format->format; });
        for (auto f = of_format; f != end; ++f) rate(*f, folder, photos);
        const CameraChoice& own = *std::ranges::max_element(of_format, end, {}, &CameraChoice::rank);
        if (!best || own.matched > best->matched || best->cameras == 0) best = &own;
        if (best->matched > 0 && best->matched >= std::ssize(photos)) break;
        of_format = end;
    }
    return *best;
}

/// Returns the file that fits best and notes the unused files. If there is only one file, it is not read.
fs::path best_fitting(const fs::path& root, std::span<const FormatFiles> files, InputFiles& found) {
    const bool by_mesh = !found.mesh.empty() && common_folder(found.mesh, root) == root;
    std::vector<CameraChoice> all = choices(files, by_mesh ? found.mesh.parent_path() : root);
    if (all.size() < 2) return all.empty() ? fs::path() : all.front().path;
    const fs::path& folder = found.photos.empty() ? root : found.photos;
    const CameraChoice& best = best_of(all, folder, photos_below(folder));
    const auto name = [&](const CameraChoice& f) {
        const fs::path in_root = f.path.lexically_relative(root);
        return (in_root == "." ? root : in_root).string() +
               (f.format == best.format ? "" : std::string(" (") + f.format->name + ")");
    };
    for (const CameraChoice& f : all) {
        const bool is_part = best.format->one_per_photo && f.format == best.format &&
                             common_folder(f.path, best.path) == best.path;
        if (&f == &best || is_part || best.cameras == 0) continue;
        const std::string why = !f.flaw.empty() ? ", " + f.flaw
                                : f.cameras > 0 ? ", has " + std::to_string(f.cameras) + " cameras"
                                                : "";
        found.notes.push_back(name(f) + ": not used" + why + "; " + name(best) + " has " +
                              std::to_string(best.cameras));
    }
    return best.path;
}

/// One camera file per image set, each in its image set's folder, and the folder that contains them all;
/// empty if the files are arranged differently.
struct CamerasOfImageSets {
    Files cameras;
    fs::path photos;
};
std::optional<CamerasOfImageSets> cameras_of_image_sets(const fs::path& root, const Files& files,
                                                        const std::string& how) {
    CamerasOfImageSets out{files, {}};
    std::set<fs::path> folders;
    for (const fs::path& cameras : out.cameras) {
        const fs::path folder = image_set_folder(root, cameras, how);
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

}  // namespace

std::ptrdiff_t distance(const fs::path& from, const fs::path& to) {
    const fs::path steps = to.lexically_relative(from);
    return std::distance(steps.begin(), steps.end());
}

void find_cameras(const fs::path& folder, const Files& files, InputFiles& found) {
    if (!found.cameras.empty()) return;
    const std::vector<FormatFiles> all = files_by_format(files);
    const auto of_image_sets = !all.empty() && found.photos.empty() && found.image_sets != image_sets_off
                                   ? cameras_of_image_sets(folder, all.front().files, found.image_sets)
                                   : std::nullopt;
    if (!of_image_sets) {
        found.cameras = best_fitting(folder, all, found);
        return;
    }
    found.cameras = of_image_sets->cameras.front();
    found.more_cameras.assign(of_image_sets->cameras.begin() + 1, of_image_sets->cameras.end());
    found.photos = of_image_sets->photos;
}

}  // namespace vantage
