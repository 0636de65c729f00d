#pragma once
#include <numeric>
#include <optional>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "player/measure/evaluation/held_out.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {

namespace fs = std::filesystem;

class Evaluate : public TemporaryFolder {
  protected:
    fs::path file = dir / "scene.vantage";
    SceneInput scene;
    /// Five photos taken close to each other.
    static SynthSpec close_photos() {
        SynthSpec spec = spec_named("tiny");
        spec.photos.width = 800;
        spec.photos.height = 600;
        spec.photos.arc = 40;
        return spec;
    }
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = close_photos();
        spec.photos.samples = 2;
        copy_scene(spec, dir / "scene");
        scene = read_scene(discover(dir / "scene"));
        for (PhotoInput& photo : scene.photos) photo.read.clear();  // tests repaint photos intentionally
    }
    /// Evaluates every photo, or only one.
    std::vector<PhotoEvaluation> evaluate(bool corrects_exposure = true,
                                          std::optional<std::uint32_t> only = {}) {
        PrepareSettings as_given;
        as_given.effects[Effect::pose_refinement] = EffectChoice::off;
        if (!corrects_exposure) as_given.effects[Effect::exposure] = EffectChoice::off;
        prepare(scene, as_given, file, [](const Progress&) {});
        const PackageReader package(file);
        const gl::HeadlessContext context(gl::Debug::on);
        Renderer renderer(package, {});
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        std::vector<PhotoEvaluation> out;
        std::vector<RegionError> regions;
        EvaluationPictures pictures;
        RenderSettings settings;
        settings.weights.transient_mask = false;  // as in run_evaluate
        for (const std::uint32_t p : photos)
            if (!only || p == *only)
                out.push_back(evaluate_held_out(renderer, settings, {p, 1, photos, package.photos()}, regions,
                                                pictures));
        remark(out);
        return out;
    }
    PhotoEvaluation evaluate_photo(std::uint32_t photo, bool corrects_exposure = true) {
        return evaluate(corrects_exposure, photo).front();
    }
};
class EvaluateAtLength : public Evaluate {};

/// Repaints a photo's file. `paint` receives each pixel's channels and position.
void repaint(const fs::path& file, const auto& paint) {
    const RgbaImage image = image_files().read(file);
    std::vector<std::byte> rgb;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t i = 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
            std::array<std::uint8_t, 3> color{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
            paint(color, x, y);
            for (const std::uint8_t v : color) rgb.push_back(std::byte(v));
        }
    image_files().write(file, image.width, image.height, 3, Sample::u8, rgb);
}

/// Paints a red passer-by who is half as tall as the photo.
inline void paint_passer_by(std::array<std::uint8_t, 3>& color, int x, int y) {
    if (x >= 360 && x < 460 && y >= 150 && y < 450) color = {200, 30, 30};
}

}  // namespace vantage
