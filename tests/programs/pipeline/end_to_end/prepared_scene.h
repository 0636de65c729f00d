#pragma once
#include <cmath>
#include <numeric>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {

namespace fs = std::filesystem;

/// A scene, its package and its renderer.
struct Prepared {
    SceneInput scene;
    fs::path file;
    std::unique_ptr<PackageReader> package;
    std::unique_ptr<gl::HeadlessContext> context;
    std::unique_ptr<Renderer> renderer;
    std::vector<std::uint32_t> photos;

    Prepared(const fs::path& folder, const fs::path& to, const PrepareSettings& settings = {})
        : scene(read_scene(discover(folder))), file(to) {
        copy_package(folder, settings, file);
        open();
    }
    Prepared(SceneInput input, const fs::path& to, const PrepareSettings& settings = {})
        : scene(std::move(input)), file(to) {
        prepare(scene, settings, file, [](const Progress&) {});
        open();
    }
    void open() {
        package = std::make_unique<PackageReader>(file);
        context = std::make_unique<gl::HeadlessContext>(gl::Debug::on);
        renderer = std::make_unique<Renderer>(*package, MemoryBudget{});
        photos.resize(package->photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
    }
    Picture picture(const View& view, const RenderSettings& settings) {
        return take_picture(*renderer, view, settings, photos, 1);
    }
    /// A photo's own view, with `count` photos blended (0: all photos).
    Picture own_view(std::uint32_t photo, Blend blend, int per_pass = 4, int count = 0) {
        RenderSettings s;
        s.blend = blend;
        s.photos = count;
        s.photos_per_pass = per_pass;
        return picture(view_of_photo(package->photos()[photo], 1), s);
    }
};

class EndToEnd : public TemporaryFolder {
  protected:
    static SynthSpec tiny() { return spec_named("tiny"); }
    fs::path make(const SynthSpec& spec) {
        copy_scene(spec, dir / "scene");
        return dir / "scene";
    }
    Prepared prepared(const fs::path& folder) {
        PrepareSettings settings;
        settings.vertex_coordinates = true;
        return Prepared(folder, dir / "scene.vantage", settings);
    }
};

class EndToEndAtLength : public EndToEnd {};

/// The PSNR over the colored pixels in 8-bit sRGB; 200 if the pictures are identical.
inline double psnr(const Picture& picture, const std::vector<std::uint8_t>& rgba) {
    double sum = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        if (picture.rgba[i + 3] < 128) continue;
        for (std::size_t c = 0; c < 3; ++c, ++n) {
            const double d = double(picture.rgba[i + c]) - double(rgba[i + c]);
            sum += d * d;
        }
    }
    if (n == 0) return 0;
    return sum > 0 ? 10 * std::log10(255.0 * 255.0 * double(n) / sum) : 200;
}

}  // namespace vantage
