// Tests that effects that a scene does not need are off, and that they change nothing if they are forced on.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/model_builder.h"
#include "player/render/picture.h"
#include "tests/programs/scan_of_model.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

/// A wall of triangles smaller than two pixels, which fills all photos. All photos are taken by one camera in
/// the same light.
class CalmScene : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        ModelBuilder b{{}, 0.033};
        b.quad({-6, 0, -3}, {12, 0, 0}, {0, 0, 9}, Material::brick);
        std::vector<Camera> cameras;
        for (int i = 0; i < 5; ++i) {
            Camera c;
            c.intrinsics = {240, 180, 195, 195, 120, 90};
            c.cam_from_world = look_at({0.8 * (i - 2), -6, 1.7 + 0.2 * (i % 2)}, {0.3 * (i - 2), 0, 1.8});
            cameras.push_back(c);
        }
        write_scan(dir / "scan", b.model, cameras);
    }
    PackageReader prepared(const PrepareSettings& settings) const {
        return PackageReader(made_package(dir / "scan", settings));
    }
    /// Views between the photos, in which all photos show the wall. At the edge of a photo's frame, exact
    /// coordinates would extend the photo by a pixel.
    static std::vector<std::uint8_t> pictures(const PackageReader& package) {
        const gl::HeadlessContext context;
        Renderer renderer(package, MemoryBudget{});
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        std::vector<std::uint8_t> out;
        for (const std::uint32_t from : {0u, 2u, 3u}) {
            View view = view_of_photo(package.photos()[from], 1);
            view.cam_from_origin.t -= Vector3d(0.4, 0.1, 0.3);
            view.intrinsics.fx = view.intrinsics.fy = 480;
            const Picture p = take_picture(renderer, view, {}, photos, 1);
            out.insert(out.end(), p.rgba.begin(), p.rgba.end());
        }
        return out;
    }
};
class CalmSceneAtLength : public CalmScene {};

/// The 99.9th percentile of the absolute differences between 8-bit values.
int percentile_99_9(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::vector<int> off;
    for (std::size_t i = 0; i < a.size(); ++i) off.push_back(std::abs(int(a[i]) - int(b[i])));
    const auto at = off.begin() + std::ptrdiff_t(0.999 * double(off.size()));
    std::ranges::nth_element(off, at);
    return *at;
}

}  // namespace

TEST_F(CalmSceneAtLength, CallsForNoEffectAndLooksTheSameWithEachForcedOn) {
    std::vector<std::uint8_t> plain;
    {
        const PackageReader package = prepared({});
        EXPECT_EQ(package.scene().effects & ~effect_bit(Effect::compact), 0u);
        plain = pictures(package);
        std::size_t colored = 0;
        for (std::size_t i = 3; i < plain.size(); i += 4) colored += plain[i] == 255;
        ASSERT_GT(double(colored), 0.99 * double(plain.size() / 4));
    }
    for (const EffectRow& row : effect_table()) {
        if (row.effect == Effect::compact) continue;  // corrects nothing; compact_test.cpp has its bounds
        PrepareSettings settings;
        settings.effects[row.effect] = EffectChoice::on;
        const PackageReader package = prepared(settings);
        EXPECT_EQ(package.scene().effects & ~effect_bit(row.effect) & ~effect_bit(Effect::compact), 0u)
            << row.option;
        const auto shown = pictures(package);
        ASSERT_EQ(shown.size(), plain.size());
        EXPECT_LE(percentile_99_9(shown, plain), 1) << row.option;
    }
}
