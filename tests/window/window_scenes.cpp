#include "tests/window/window_scenes.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "tests/made_scenes.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed when the process ends.
struct Folder {
    const fs::path path = fs::temp_directory_path() / ("vantage-window-scenes-" + std::to_string(::getpid()));
    ~Folder() {
        std::error_code error;
        fs::remove_all(path, error);
    }
};

const fs::path& folder() {
    static const Folder made;
    return made.path;
}

SynthSpec small_photos(const char* name) {
    SynthSpec spec = spec_named(name);
    spec.photos.width = 96, spec.photos.height = 72, spec.photos.samples = 1;
    if (spec.infrared.count) spec.infrared.width = 80, spec.infrared.height = 60;
    return spec;
}

/// Renames the photos so that their alphabetical order differs from their order around the building.
void shuffle_names(const fs::path& scan, int photos) {
    const auto name = [](int number) {
        char text[16];
        std::snprintf(text, sizeof text, "%04d.jpg", number);
        return std::string(text);
    };
    const fs::path images = scan / "images", ordered = scan / "ordered", list = scan / "sparse/images.txt";
    fs::rename(images, ordered);
    fs::create_directory(images);
    std::ostringstream text;
    text << std::ifstream(list).rdbuf();
    std::string lines = text.str();
    for (int i = 0; i < photos; ++i) {
        const std::string old = name(i), shuffled = name(i * 7 % photos);
        fs::rename(ordered / old, images / shuffled);
        lines.replace(lines.find(" " + old + "\n"), old.size() + 1, " new-" + shuffled);
    }
    for (std::size_t at; (at = lines.find(" new-")) != lines.npos;) lines.erase(at + 1, 4);
    std::ofstream(list) << lines;
}

void make(WindowScene scene, const fs::path& scan, const fs::path& package) {
    SynthSpec spec = small_photos(scene == WindowScene::image_sets ? "image_sets" : "tiny");
    PrepareSettings settings;
    settings.vertex_coordinates = scene == WindowScene::tiny;
    if (scene == WindowScene::garden) {
        spec.height_field = true;
        spec.garden = {.radius = 30, .hill = 8};
        spec.glass.alpha = 0.3;
        settings.effects[Effect::background] = EffectChoice::on;
    }
    if (scene == WindowScene::many) spec.photos.count = 60, spec.object.triangles = 600;
    copy_scene(spec, scan);
    if (scene == WindowScene::many) shuffle_names(scan, spec.photos.count);
    if (scene != WindowScene::garden) return copy_package(scan, settings, package);
    InputFiles given;
    given.points = {folder() / "cloud.ply"};
    fs::copy_file(scan / "mesh.ply", given.points.front());
    prepare(read_scene(discover(scan, given)), settings, package, [](const Progress&) {});
}

const char* name_of(WindowScene scene) {
    return std::array{"tiny", "garden", "image_sets", "many"}[std::size_t(scene)];
}

fs::path scan_of(WindowScene scene) { return folder() / name_of(scene); }

}  // namespace

fs::path package_of(WindowScene scene) {
    const fs::path file = scan_of(scene).concat(".vantage");
    if (!fs::exists(file)) {
        fs::create_directories(folder());
        make(scene, scan_of(scene), file);
    }
    return file;
}

fs::path images_of(WindowScene scene) {
    package_of(scene);
    return scan_of(scene) / "sparse/images.txt";
}

}  // namespace vantage
