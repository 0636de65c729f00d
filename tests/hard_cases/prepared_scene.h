#pragma once
#include <memory>
#include <numeric>

#include "base/gl/context.h"
#include "pipeline/run/settings.h"
#include "player/render/picture.h"
#include "scene/package/package_reader.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

namespace vantage {

/// A package with five small photos, and a renderer for it.
class PreparedScene : public TemporaryFolder {
  protected:
    std::filesystem::path file = dir / "scene.vantage";
    std::unique_ptr<PackageReader> package;
    std::unique_ptr<gl::HeadlessContext> context;
    std::unique_ptr<Renderer> renderer;
    std::vector<std::uint32_t> photos;

    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(spec(), dir / "scene");
        change(dir / "scene");
        copy_package(dir / "scene", settings(), file);
        package = std::make_unique<PackageReader>(file);
        context = std::make_unique<gl::HeadlessContext>(gl::Debug::on);
        renderer = std::make_unique<Renderer>(*package, MemoryBudget{});
        photos.resize(package->photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
    }
    void TearDown() override {
        renderer.reset();
        context.reset();
        package.reset();
        TemporaryFolder::TearDown();
    }
    virtual SynthSpec spec() const { return spec_named("tiny"); }
    virtual PrepareSettings settings() const { return {}; }
    /// A hook for changing the scene's files before they are prepared.
    virtual void change(const std::filesystem::path&) const {}

    Picture picture(const View& view, const RenderSettings& s, int side = 1) {
        return take_picture(*renderer, view, s, photos, side);
    }
    View own_view(std::uint32_t photo, double scale) const {
        return view_of_photo(package->photos()[photo], scale);
    }
    /// A view halfway between two photos.
    View between(std::uint32_t a, std::uint32_t b, int width, int height, double fov = 45) const {
        const Eigen::Vector3d eye = (cam_from_origin(package->photos()[a]).center() +
                                     cam_from_origin(package->photos()[b]).center()) /
                                    2;
        return view_towards(eye, {0, 0, 0}, up_of(package->scene()), fov, width, height);
    }
};

}  // namespace vantage
