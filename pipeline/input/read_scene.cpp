#include "pipeline/input/read_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/formats/images/image_files.h"
#include "pipeline/formats/images/photos.h"
#include "pipeline/formats/import/cameras.h"
#include "pipeline/formats/import/mesh.h"
#include "pipeline/input/discover.h"
#include "scene/error.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

fs::path find_photo(const fs::path& folder, const std::string& name) {
    const fs::path wanted(name);
    for (const fs::path& candidate :
         {folder / wanted, folder / wanted.filename(), folder.parent_path() / wanted})
        if (fs::is_regular_file(candidate)) return candidate;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().stem() == wanted.stem() && is_photo(entry.path())) return entry.path();
    return {};
}

/// Fits the camera to the photo's size: fills in an unknown size, or scales a calibration made at another
/// resolution. Throws Error(input) if the aspect ratios differ.
void fit_to_photo(PhotoInput& photo, bool size_known, SceneInput& scene) {
    const PhotoHeader header = read_photo_header(photo.file);
    const PhotoSize size = header.size;
    if (!header.profile.empty())
        scene.warnings.push_back(photo.name + ": has the color profile '" + header.profile +
                                 "', treated as sRGB");
    Intrinsics& k = photo.camera.intrinsics;
    if (!size_known) {
        k = {size.width, size.height, k.fx, k.fy, size.width / 2.0, size.height / 2.0};
        return;
    }
    const bool same = k.width == size.width && k.height == size.height;
    const bool rotated = k.width == size.height && k.height == size.width;
    if (same || rotated) return;
    const double x = double(size.width) / k.width, y = double(size.height) / k.height;
    const std::string sizes = std::to_string(size.width) + "x" + std::to_string(size.height) +
                              ", but its camera expects " + std::to_string(k.width) + "x" +
                              std::to_string(k.height);
    if (!(std::abs(x / y - 1) < 0.005)) throw Error(Exit::input, photo.file.string() + ": is " + sizes);
    scene.warnings.push_back(photo.name + ": is " + sizes + "; scaled the camera");
    k = k.scaled(size.width, size.height);
}

/// A photo with its camera, both checked. Throws Error(input) if they cannot be used.
PhotoInput read_photo_input(const CameraSet::Entry& entry, const fs::path& file, SceneInput& scene) {
    PhotoInput photo{file.filename().string(), file, entry.camera};
    fit_to_photo(photo, entry.size_known, scene);
    photo.decoded = {photo.camera.intrinsics.width, photo.camera.intrinsics.height};
    photo.stencil = find_stencil(file);
    validate(photo.camera, photo.name);
    return photo;
}

void add_photos(SceneInput& scene, const CameraSet& set) {
    std::set<fs::path> used;
    for (const CameraSet::Entry& entry : set.entries) {
        const fs::path file = find_photo(scene.files.photos, entry.photo);
        if (file.empty()) {
            scene.left_out.push_back({entry.photo, "has a camera but no photo"});
            continue;
        }
        if (!used.insert(file).second) throw Error(Exit::input, file.string() + ": has more than one camera");
        try {
            scene.photos.push_back(read_photo_input(entry, file, scene));
        } catch (const Error& e) {
            scene.left_out.push_back({file.filename().string(), reason_of(e, file)});
        }
    }
    for (const auto& entry : fs::directory_iterator(scene.files.photos))
        if (is_photo(entry.path()) && !used.contains(entry.path()))
            scene.left_out.push_back({entry.path().filename().string(), "has no camera"});
    std::ranges::sort(scene.photos, {}, &PhotoInput::name);
    std::ranges::sort(scene.left_out, {}, &UnusablePhoto::photo);
    std::ranges::sort(scene.warnings);
    const auto duplicate = std::ranges::adjacent_find(scene.photos, {}, &PhotoInput::name);
    if (duplicate != scene.photos.end())
        throw Error(Exit::input, duplicate->file.string() + ": another photo has the same name");
}

}  // namespace

SceneInput read_scene(const InputFiles& files) {
    SceneInput scene;
    scene.files = files;
    const CameraSet set = read_cameras(files.cameras);
    scene.camera_format = set.format;
    scene.warnings = set.warnings;
    scene.mesh = read_mesh(files.mesh, scene.warnings);
    if (!fs::is_directory(files.photos)) throw Error(Exit::input, files.photos.string() + ": not a folder");
    add_photos(scene, set);
    if (scene.photos.empty())
        throw Error(Exit::input,
                    files.photos.string() + ": no photo has a camera in " + files.cameras.string());
    return scene;
}

}  // namespace vantage
