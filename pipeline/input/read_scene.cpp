#include "pipeline/input/read_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

#include "base/text/error.h"
#include "base/text/file_name.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/formats/cloud.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/image_set_groups.h"
#include "pipeline/input/masks.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// Completes intrinsics that lack the photo's size.
Intrinsics in_pixels(const Intrinsics& k, CameraSet::Unit unit, const PhotoSize& size) {
    using Unit = CameraSet::Unit;
    const double scale = unit == Unit::photo_width   ? size.width
                         : unit == Unit::longer_side ? std::max(size.width, size.height)
                                                     : 1;
    const double middle = unit == Unit::pixels_from_corner ? 0 : 0.5;
    return {size.width,
            size.height,
            scale * k.fx,
            scale * k.fy,
            scale * k.cx + middle * size.width,
            scale * k.cy + middle * size.height};
}

/// Whether the photo has its camera's aspect ratio only when displayed, turned by 90 degrees.
bool turns_to_fit(const PhotoHeader& header, const Intrinsics& k) {
    const auto [width, height] = header.size;
    const auto difference = [&](double x, double y) {
        return std::abs(std::log(k.width * y / (k.height * x)));
    };
    return header.orientation >= 5 && difference(height, width) < difference(width, height);
}

/// The EXIF orientation if it is ambiguous. Pixels are used as stored, but the camera may refer to the photo
/// as displayed. A turn by 90 degrees usually shows in the camera's size, but the pixels may already have
/// been turned.
int open_turn(const PhotoHeader& header, CameraSet::Unit unit, bool turns) {
    using Unit = CameraSet::Unit;
    if (header.orientation < 5) return header.orientation == 1 ? 0 : header.orientation;
    const bool square = header.size.width == header.size.height;
    if (square || (unit != Unit::pixels && unit != Unit::photo_width)) return header.orientation;
    return turns ? 3 : 0;
}

/// Fits the camera to the photo's size: fills in an unknown size, or scales a calibration made at another
/// resolution. Throws Error(input) if the aspect ratios differ.
void fit_to_photo(PhotoInput& photo, CameraSet::Unit unit, SceneInput& scene) {
    const PhotoHeader header = read_photo_header(photo.file);
    photo.linear = header.linear;
    photo.profile = header.profile;
    photo.orientation = header.orientation;
    Intrinsics& k = photo.camera.intrinsics;
    const bool turns = unit == CameraSet::Unit::pixels && turns_to_fit(header, k);
    photo.open_turn = open_turn(header, unit, turns);
    PhotoSize size = header.size;
    if (turns) std::swap(size.width, size.height);
    if (unit != CameraSet::Unit::pixels) {
        k = in_pixels(k, unit, size);
        return;
    }
    if (k.width == size.width && k.height == size.height) return;
    const double x = double(size.width) / k.width, y = double(size.height) / k.height;
    const std::string sizes = "is " + std::to_string(header.size.width) + "x" +
                              std::to_string(header.size.height) + ", but its camera expects " +
                              std::to_string(k.width) + "x" + std::to_string(k.height);
    if (!(std::abs(x / y - 1) < 0.005)) throw Error(Exit::input, photo.file.string() + ": " + sizes);
    scene.warnings.push_back(photo.name + ": " + sizes + "; scaled the camera");
    k = k.scaled(size.width, size.height);
}

/// The names of files in a package: the file name or, for files with equal names, the path in the photos'
/// folder with _ between its parts. If that is still ambiguous, leading underscores are added.
std::map<fs::path, std::string> package_names(const fs::path& folder, const std::set<fs::path>& files) {
    std::map<std::string, int> count;
    for (const fs::path& file : files) ++count[utf8_name(file.filename().string())];
    std::map<fs::path, std::string> names;
    std::set<std::string> taken;
    for (const fs::path& file : files) {
        std::string name = utf8_name(file.filename().string());
        if (count.at(name) > 1) {
            name = name_below(folder, file);
            std::ranges::replace(name, '/', '_');
        }
        while (!taken.insert(name).second) name = "_" + name;
        names[file] = name;
    }
    return names;
}

/// A photo and its camera, both validated. Throws Error(input) if either is unusable.
PhotoInput read_photo_input(const CameraSet::Entry& entry, const fs::path& file, const std::string& name,
                            Masks& masks, SceneInput& scene) {
    PhotoInput photo{name, file, entry.camera};
    photo.mask = masks.of(file);
    photo.read.push_back(stamped(file));
    if (!photo.mask.empty()) photo.read.push_back(stamped(photo.mask));
    fit_to_photo(photo, entry.unit, scene);
    photo.decoded = {photo.camera.intrinsics.width, photo.camera.intrinsics.height};
    validate(photo.camera, photo.name);
    return photo;
}

/// All cameras and their photos.
struct FoundPhotos {
    CameraSet set;
    std::vector<fs::path> files;       ///< empty for cameras without a photo
    std::vector<std::string> why_not;  ///< the reason for a missing photo, per camera
};

constexpr const char* without_photo = "has a camera but no photo";

std::string name_of(const CameraSet::Entry& camera) {
    return camera.group.empty() ? camera.photo : camera.group + "/" + camera.photo;
}

/// "A.jpg, B.jpg or C.jpg", as paths in the folder.
std::string alternatives(const std::vector<fs::path>& files, const fs::path& folder) {
    std::string out;
    for (std::size_t i = 0; i < files.size(); ++i)
        out += (i == 0 ? "" : i + 1 < files.size() ? ", " : " or ") + name_below(folder, files[i]);
    return out;
}

/// A camera file and its cameras.
struct CameraFile {
    fs::path file;
    CameraSet set;
};

/// Throws Error(input) if a photo has two cameras.
void add_found(CameraFile&& cameras, const fs::path& folder, const std::vector<fs::path>& photos,
               FoundPhotos& found) {
    std::vector<CameraSet::Entry>& entries = cameras.set.entries;
    std::map<fs::path, std::string> used;  // and the camera that uses each
    for (std::size_t i = 0; i < found.files.size(); ++i) used[found.files[i]] = name_of(found.set.entries[i]);
    const std::vector<PhotoMatch> matches = match_photos(folder, photos, entries);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const fs::path& file = matches[i].file;
        found.files.push_back(file);
        found.why_not.push_back(matches[i].candidates.empty()
                                    ? without_photo
                                    : "may be " + alternatives(matches[i].candidates, folder) +
                                          ": expected the photo's folder in " + cameras.file.string());
        if (file.empty()) continue;
        if (const auto [other, is_new] = used.try_emplace(file, name_of(entries[i])); !is_new)
            throw Error(Exit::input, file.string() + ": has more than one camera, '" + other->second +
                                         "' and '" + name_of(entries[i]) + "' in " + cameras.file.string());
    }
    found.set.entries.insert(found.set.entries.end(), std::make_move_iterator(entries.begin()),
                             std::make_move_iterator(entries.end()));
}

/// The subfolder of the photos' folder that contains the camera file, for scans with one camera file per
/// subfolder.
fs::path folder_of(const fs::path& cameras, const fs::path& photos) {
    return photos / *cameras.lexically_relative(photos).begin();
}

std::vector<CameraFile> read_camera_files(const InputFiles& files) {
    std::vector<CameraFile> out{{files.cameras, read_cameras(files.cameras)}};
    for (const fs::path& more : files.more_cameras) out.push_back({more, read_cameras(more)});
    return out;
}

FoundPhotos find_photos(std::vector<CameraFile> cameras, const fs::path& photos,
                        const std::vector<fs::path>& all) {
    FoundPhotos found;
    found.set.format = cameras.front().set.format;
    if (cameras.size() == 1) {
        add_found(std::move(cameras.front()), photos, all, found);
        return found;
    }
    for (CameraFile& c : cameras) {
        const fs::path folder = folder_of(c.file, photos);
        const std::size_t before = found.set.entries.size();
        add_found(std::move(c), folder, photos_below(folder), found);
        for (std::size_t i = before; i < found.set.entries.size(); ++i)
            found.set.entries[i].photo = (folder.filename() / found.set.entries[i].photo).generic_string();
    }
    return found;
}

void set_image_sets(SceneInput& scene) {
    std::vector<fs::path> paths;
    for (const PhotoInput& p : scene.photos) paths.push_back(p.file.lexically_relative(scene.files.photos));
    ImageSetGroups groups = group_image_sets(paths, scene.files.image_sets);
    if (!groups.note.empty()) scene.files.notes.push_back(groups.note);
    for (std::size_t i = 0; i < scene.photos.size(); ++i) scene.photos[i].image_set = groups.of_photo[i];
    if (!groups.names.empty()) scene.image_sets = std::move(groups.names);
}

/// The conversion of a photo's colors, as a phrase that follows "holds"; empty if they are kept.
std::string said_of_colors(const PhotoInput& photo) {
    const ProfileUse& profile = photo.profile;
    const std::string name =
        profile.name.empty() ? "a color profile" : "the color profile '" + profile.name + "'";
    if (photo.linear) return "linear light: converted to sRGB; values above 1 are clipped";
    if (profile.converts) return name + ": converted to sRGB; colors outside sRGB are clipped";
    if (!profile.flaw.empty())
        return name + ", which cannot be used because " + profile.flaw + ": treated as sRGB";
    return {};
}

/// "A.jpg and 2 other photos hold".
std::string holders(const std::vector<std::string>& photos) {
    const std::string& first = photos.front();
    if (photos.size() == 1) return first + " holds";
    if (photos.size() == 2) return first + " and another photo hold";
    return first + " and " + std::to_string(photos.size() - 1) + " other photos hold";
}

/// Adds one warning for all photos with the same color conversion.
void warn_of_colors(SceneInput& scene) {
    std::map<std::string, std::vector<std::string>> photos;  // by the text about their colors
    for (const PhotoInput& photo : scene.photos) photos[said_of_colors(photo)].push_back(photo.name);
    photos.erase("");
    for (const auto& [said, names] : photos) scene.warnings.push_back(holders(names) + " " + said);
}

void add_photos(SceneInput& scene, std::vector<CameraFile> cameras) {
    const fs::path& folder = scene.files.photos;
    const std::vector<fs::path> photos = photos_below(folder);
    const auto [set, files, why_not] = find_photos(std::move(cameras), folder, photos);
    std::set<fs::path> used(files.begin(), files.end());
    used.erase(fs::path());
    const std::map<fs::path, std::string> names = package_names(folder, used);
    const auto skip = [&](const fs::path& file, const std::string& why) {
        scene.skipped.push_back({name_below(folder, file), why});
    };
    Masks masks;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].empty()) {
            scene.skipped.push_back({utf8_name(name_of(set.entries[i])), why_not[i]});
            continue;
        }
        const StampedFile before = stamped(files[i]);
        try {
            scene.photos.push_back(
                read_photo_input(set.entries[i], files[i], names.at(files[i]), masks, scene));
        } catch (const UnreadableFile& e) {
            // The file's content is not identified, so the next run tries again.
            skip(files[i], reason_of(e, files[i]));
        } catch (const Error& e) {
            skip(files[i], reason_of(e, files[i]));
            scene.skipped.back().file = files[i];
            scene.read.push_back(before);
        }
    }
    for (const fs::path& file : unused_photos(folder, photos, {used.begin(), used.end()}))
        skip(file, without_camera);
    std::ranges::sort(scene.photos, {}, &PhotoInput::name);
    warn_of_colors(scene);
    std::ranges::sort(scene.skipped, {}, &UnusablePhoto::photo);
    std::ranges::sort(scene.warnings);
}

/// Reads a mesh and records its companions.
Mesh read_mesh_of(SceneInput& scene, const fs::path& file) {
    scene.read.push_back(stamped(file));
    std::vector<fs::path>& companions = scene.files.companions[file];
    Mesh mesh = read_mesh(file, scene.warnings, &companions);
    for (const fs::path& companion : companions) scene.read.push_back(stamped(companion));
    return mesh;
}

/// Reads the reference meshes. Throws Error(usage) if two reference meshes have the same name.
void read_compared(SceneInput& scene) {
    std::set<fs::path> names;
    for (const fs::path& file : scene.files.compared) {
        if (!names.insert(file.filename()).second)
            throw Error(Exit::usage, file.string() + ": another --deviation-from file has the same name");
        scene.compared.push_back(read_mesh_of(scene, file));
    }
}

/// Reads all points into one cloud. If only some files have colors, the points of the others are light gray.
void read_clouds(SceneInput& scene) {
    constexpr std::array<std::uint8_t, 4> gray{200, 200, 200, 255};
    Mesh& all = scene.points;
    for (const fs::path& file : scene.files.points) {
        scene.read.push_back(stamped(file));
        Mesh cloud = read_cloud(file, scene.warnings);
        if (all.positions.empty()) {
            all = std::move(cloud);
            continue;
        }
        if (!cloud.colors.empty()) all.colors.resize(all.positions.size(), gray);
        all.positions.insert(all.positions.end(), cloud.positions.begin(), cloud.positions.end());
        all.colors.insert(all.colors.end(), cloud.colors.begin(), cloud.colors.end());
        if (!all.colors.empty()) all.colors.resize(all.positions.size(), gray);
    }
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
    if (all.positions.size() > most)
        throw Error(Exit::input, scene.files.points.front().string() + ": " +
                                     std::to_string(all.positions.size()) + " points, expected at most " +
                                     std::to_string(most));
}

/// Throws because no photo remains, and gives the reason if photos exist but are unusable.
[[noreturn]] void fail_without_photos(const SceneInput& scene) {
    const std::string folder = scene.files.photos.string(), cameras = scene.files.cameras.string();
    const auto unusable = std::ranges::find_if(scene.skipped, [](const UnusablePhoto& l) {
        return l.why != without_camera && l.why != without_photo;
    });
    if (unusable != scene.skipped.end())
        throw Error(Exit::input,
                    folder + ": no photo can be used; " + unusable->photo + ": " + unusable->why);
    const auto first = [&](const char* why) {
        const auto it = std::ranges::find(scene.skipped, why, &UnusablePhoto::why);
        return it == scene.skipped.end() ? std::string("none") : "'" + it->photo + "'";
    };
    throw Error(Exit::input, folder + ": no photo has a camera in " + cameras + "; the first photo is " +
                                 first(without_camera) + ", and the first camera's photo is " +
                                 first(without_photo));
}

}  // namespace

SceneInput read_scene(const InputFiles& files) {
    SceneInput scene;
    scene.files = files;
    std::vector<CameraFile> cameras;
    if (!files.cameras.empty()) {
        for (const fs::path& file : camera_files(files.cameras)) scene.read.push_back(stamped(file));
        for (const fs::path& more : files.more_cameras)
            for (const fs::path& file : camera_files(more)) scene.read.push_back(stamped(file));
        if (is_image_sets_file(files.image_sets)) scene.read.push_back(stamped(files.image_sets));
        cameras = read_camera_files(files);
        scene.camera_format = cameras.front().set.format;
        scene.transform = cameras.front().set.transform;
    }
    for (const CameraFile& c : cameras)
        scene.warnings.insert(scene.warnings.end(), c.set.warnings.begin(), c.set.warnings.end());
    if (!files.mesh.empty()) scene.mesh = read_mesh_of(scene, files.mesh);
    read_compared(scene);
    read_clouds(scene);
    if (files.photos.empty() && has_points_only(scene)) return scene;
    if (!fs::exists(files.photos)) throw Error(Exit::input, files.photos.string() + ": does not exist");
    if (!fs::is_directory(files.photos)) throw Error(Exit::input, files.photos.string() + ": not a folder");
    if (!cameras.empty()) add_photos(scene, std::move(cameras));
    if (scene.photos.empty() && !has_points_only(scene)) fail_without_photos(scene);
    if (files.align)
        for (PhotoInput& p : scene.photos)
            p.camera.cam_from_world = compose(p.camera.cam_from_world, inverse(*files.align));
    if (!scene.photos.empty()) set_image_sets(scene);
    return scene;
}

}  // namespace vantage
