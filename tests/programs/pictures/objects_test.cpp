// Compares several objects in one picture with each object alone and with the first intersections of rays.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/values/srgb.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/synthesize.h"
#include "player/composition/object_set.h"
#include "player/composition/object_view.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

/// Three small buildings, each of which has its own photos.
class Objects : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        for (unsigned i = 0; i < 3; ++i) {
            const std::string name = "object" + std::to_string(i);
            SynthSpec spec = spec_named("tiny");
            spec.seed = 3 + i;
            spec.building.width = 5 + 1.5 * i;
            spec.object.triangles = 2000;
            spec.photos.count = 4, spec.photos.samples = 1;
            copy_scene(spec, dir / name);
            SceneInput input = read_scene(discover(dir / name));
            meshes.push_back(input.mesh);
            copy_package(dir / name, {}, file(i));
            scene.push_back({name, file(i), {}, true});
        }
        scene[1].placement = {{3, -2, 0}, {0, 0, 40}, 0.7};
        scene[2].placement = {{-4, 1.5, 0.5}, {0, 0, -30}, 1.2};
        first = std::make_unique<PackageReader>(file(0));
        photos.resize(first->photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
    }
    std::filesystem::path file(unsigned i) const { return dir / ("object" + std::to_string(i) + ".vantage"); }

    View view() const {
        View v = view_of_photo(first->photos()[1], 1);
        v.cam_from_origin.t += Vector3d(0, 0, 3);  // farther away
        return v;
    }
    /// Casts rays through the view's pixels at one object in its placement.
    struct PlacedRays {
        RayScene rays;
        View view;
        Vector3d origin;
        double scale;
        /// The distance along the view's axis; infinite if the ray misses the object.
        double distance(double x, double y) const {
            const Intrinsics& k = view.intrinsics;
            const Vector3d ray =
                view.cam_from_origin.R.transpose() * Vector3d((x - k.cx) / k.fx, (y - k.cy) / k.fy, 1);
            const auto hit = rays.first_hit(view.cam_from_origin.center() + origin, ray);
            return hit ? hit->distance * scale : std::numeric_limits<double>::infinity();
        }
    };
    PlacedRays placed(unsigned i) const {
        const auto origin_of = [](const PackageReader& package) {
            return Vector3d(Eigen::Map<const Vector3d>(package.scene().origin));
        };
        const Vector3d origin = origin_of(PackageReader(file(i)));
        const Placement& p = scene[i].placement;
        return {RayScene(meshes[i]), view_of_object(view(), origin_of(*first), origin, p), origin, p.scale};
    }
    std::array<PlacedRays, 3> all_rays() const { return {placed(0), placed(1), placed(2)}; }
    /// A picture of each object alone. Afterward, only the last object is shown.
    std::vector<Picture> each_alone(ObjectSet& set) const {
        std::vector<Picture> out;
        for (std::size_t i = 0; i < 3; ++i) {
            set.show_only(i);
            out.push_back(take_picture(set, view(), {}, photos, 1));
        }
        return out;
    }
    std::vector<Mesh> meshes;
    std::vector<SceneObject> scene;
    std::unique_ptr<PackageReader> first;
    std::vector<std::uint32_t> photos;
};

}  // namespace

TEST_F(Objects, EachPixelShowsTheObjectThatItsRayMeetsFirst) {
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(*first, MemoryBudget{});
    ObjectSet set(renderer, scene, MemoryBudget{});
    const Picture together = take_picture(set, view(), {}, photos, 1);
    const std::vector<Picture> alone = each_alone(set);
    const std::array<PlacedRays, 3> rays = all_rays();
    std::array<std::size_t, 3> compared{};
    std::size_t wrong = 0;
    for (int y = 2; y < together.height - 2; y += 2)
        for (int x = 2; x < together.width - 2; x += 2) {
            // The nearest object at the pixel, and whether the same object is nearest at the pixels around
            // it. At outlines, either object may be shown.
            std::optional<unsigned> nearest;
            bool inside = true;
            for (const auto& [dx, dy] : {std::pair(0, 0), {-2, 0}, {2, 0}, {0, -2}, {0, 2}}) {
                unsigned at = 0;
                double least = std::numeric_limits<double>::infinity();
                for (unsigned i = 0; i < 3; ++i) {
                    const double z = rays[i].distance(x + dx + 0.5, y + dy + 0.5);
                    if (z < least) least = z, at = i;
                }
                inside &= std::isfinite(least) && at == nearest.value_or(at);
                nearest = at;
            }
            if (!inside) continue;
            const std::size_t p = 4 * (std::size_t(y) * std::size_t(together.width) + std::size_t(x));
            ++compared[*nearest];
            const std::vector<std::uint8_t>& own = alone[*nearest].rgba;
            if (own[p + 3] < 255) continue;  // none of its photos shows it: others may shine through
            for (std::size_t c = 0; c < 4; ++c)
                wrong += std::abs(int(together.rgba[p + c]) - int(own[p + c])) > 1;
        }
    for (const std::size_t n : compared) EXPECT_GT(n, 300u);
    EXPECT_EQ(wrong, 0u);
}

TEST_F(Objects, AMatrixPlacesAnObjectWhereItLeadsItsCoordinates) {
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(*first, MemoryBudget{});
    const Vector3d origin = Eigen::Map<const Vector3d>(first->scene().origin),
                   of_object = Eigen::Map<const Vector3d>(PackageReader(file(1)).scene().origin);
    Similarity matrix{{}, {2, -1, 0.5}, 0.8};
    for (const Vector3d& turn :
         {Vector3d(0, 0, 0), Vector3d(20, -50, 130), Vector3d(30, 90, 0), Vector3d(0, -90, 77)}) {
        matrix.R = rotation_of({{}, turn});
        scene[1].placement = {};
        scene[1].matrix = matrix;
        const ObjectSet set(renderer, scene, MemoryBudget{});
        EXPECT_FALSE(set.at(1).matrix)
            << "the matrix should become a placement, so that the object can be moved";
        const View seen = view_of_object(view(), origin, of_object, set.at(1).placement);
        for (const Vector3d& p : meshes[1].positions) {
            const Vector3d here = view().cam_from_origin.R * (matrix(p) - origin) + view().cam_from_origin.t,
                           there = seen.cam_from_origin.R * (p - of_object) + seen.cam_from_origin.t;
            ASSERT_LT((0.8 * there - here).norm(), 1e-9) << turn.transpose();
        }
    }
}

TEST_F(Objects, ThroughAFadedObjectThoseBehindItShowInLinearLight) {
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(*first, MemoryBudget{});
    ObjectSet set(renderer, scene, MemoryBudget{});
    const std::vector<Picture> alone = each_alone(set);
    for (std::size_t i = 0; i < 3; ++i) set.show_object(i, true);
    const std::array<double, 3> opacity{0.7, 0.25, 0};
    for (std::size_t i = 0; i < 3; ++i) set.set_opacity(i, opacity[i]);
    const Picture faded = take_picture(set, view(), {}, photos, 1);
    const std::array<PlacedRays, 3> rays = all_rays();
    std::size_t compared = 0, wrong = 0;
    for (int y = 2; y < faded.height - 2; y += 2)
        for (int x = 2; x < faded.width - 2; x += 2) {
            const std::size_t p = 4 * (std::size_t(y) * std::size_t(faded.width) + std::size_t(x));
            std::vector<std::pair<double, unsigned>> order;
            bool inside = true;
            for (unsigned i = 0; i < 3; ++i) {
                const double z = rays[i].distance(x + 0.5, y + 0.5);
                // Pixels where an object has no color or has an outline are not compared.
                inside &= (std::isfinite(z) ? 255 : 0) == alone[i].rgba[p + 3];
                if (std::isfinite(z)) order.emplace_back(z, i);
            }
            std::ranges::sort(order);
            for (std::size_t k = 1; k < order.size(); ++k)
                inside &= order[k].first > 1.01 * order[k - 1].first;
            if (!inside || order.size() < 2) continue;
            ++compared;
            double through = 1;
            Vector3d light = Vector3d::Zero();
            for (const auto& [z, i] : order) {
                for (int c = 0; c < 3; ++c)
                    light[c] +=
                        through * opacity[i] * linear_of_srgb_byte()[alone[i].rgba[p + std::size_t(c)]];
                through *= 1 - opacity[i];
            }
            wrong += std::abs(faded.rgba[p + 3] - 255 * (1 - through)) > 1;
            for (int c = 0; c < 3 && through < 0.99; ++c)
                wrong += std::abs(faded.rgba[p + std::size_t(c)] -
                                  255 * srgb_from_linear(light[c] / (1 - through))) > 1.5;
        }
    EXPECT_GT(compared, 1000u);
    EXPECT_EQ(wrong, 0u);
}

TEST_F(Objects, OneObjectIsDrawnAsWithoutASet) {
    const gl::HeadlessContext context(gl::Debug::on);
    RenderSettings settings;
    settings.fill_holes = true;
    Renderer bare(*first, MemoryBudget{});
    const Picture expected = take_picture(bare, view(), settings, photos, 2);
    Renderer renderer(*first, MemoryBudget{});
    ObjectSet set(renderer, {scene[0]}, MemoryBudget{});
    EXPECT_EQ(take_picture(set, view(), settings, photos, 2).rgba, expected.rgba);
    set.add(scene[1]);
    EXPECT_NE(take_picture(set, view(), settings, photos, 2).rgba, expected.rgba);
    set.show_object(1, false);
    const Picture hidden = take_picture(set, view(), settings, photos, 2);
    std::size_t off = 0;
    for (std::size_t i = 0; i < expected.rgba.size(); ++i)
        off += std::abs(int(hidden.rgba[i]) - int(expected.rgba[i])) > 1;
    EXPECT_EQ(off, 0u);
    set.remove(1);
    EXPECT_EQ(take_picture(set, view(), settings, photos, 2).rgba, expected.rgba);
    set.set_opacity(0, 0.5);
    EXPECT_NE(take_picture(set, view(), settings, photos, 2).rgba, expected.rgba);
}

TEST_F(Objects, RemovingAnObjectReturnsItsMemory) {
    const gl::HeadlessContext context(gl::Debug::on);
    const MemoryBudget budget{.graphics = std::uint64_t(300) << 20};
    Renderer renderer(*first, budget);
    ObjectSet set(renderer, {scene[0]}, budget);
    take_picture(set, view(), {}, photos, 1);
    const std::uint64_t before = gl::memory_held();
    for (int round = 0; round < 3; ++round) {
        set.add(scene[1]);
        set.add(scene[2]);
        take_picture(set, view(), {}, photos, 1);
        EXPECT_LE(gl::memory_held(), (std::uint64_t(300) << 20) * 11 / 10);
        set.remove(1);
        set.remove(1);
        ASSERT_EQ(set.size(), 1u);
        take_picture(set, view(), {}, photos, 1);
        EXPECT_EQ(gl::memory_held(), before) << round;
    }
}

TEST_F(Objects, TogetherTheyKeepTheUploadLimitAndConverge) {
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(*first, MemoryBudget{});
    ObjectSet set(renderer, scene, MemoryBudget{});
    RenderSettings settings;
    settings.loading = Loading::streamed;
    settings.upload_bytes = std::size_t(2) << 20;
    std::uint64_t total = 0, most = 0;
    bool settled = false;
    for (int i = 0; i < 3000 && !settled; ++i) {
        const FrameReport report = set.draw(view(), settings, photos, {}, 1 + i / 30.0);
        total += report.uploaded;
        most = std::max<std::uint64_t>(most, report.uploaded);
        settled = report.settled && report.tiles_missing == 0;
    }
    EXPECT_TRUE(settled);
    EXPECT_LE(most, settings.upload_bytes);
    EXPECT_GT(total, 2 * settings.upload_bytes) << "the upload limit should have an effect";
}

TEST_F(Objects, MovedApartTheyAreBesideEachOtherAndBackTogetherAsBefore) {
    const gl::HeadlessContext context(gl::Debug::on);
    Renderer renderer(*first, MemoryBudget{});
    ObjectSet set(renderer, scene, MemoryBudget{});
    const auto colored = [](const Picture& p) {
        std::size_t n = 0;
        for (std::size_t i = 3; i < p.rgba.size(); i += 4) n += p.rgba[i] == 255;
        return n;
    };
    const Picture together = take_picture(set, view(), {}, photos, 1);
    Placement apart = scene[1].placement;
    apart.move = {500, 0, 0};  // outside the picture
    set.place(1, apart);
    set.place(2, apart);
    const Picture moved = take_picture(set, view(), {}, photos, 1);
    set.show_only(0);
    const Picture alone = take_picture(set, view(), {}, photos, 1);
    EXPECT_EQ(colored(moved), colored(alone));
    EXPECT_GT(colored(together), colored(alone));
    for (std::size_t i = 0; i < 3; ++i) set.show_object(i, true);
    set.place(1, scene[1].placement);
    set.place(2, scene[2].placement);
    EXPECT_EQ(take_picture(set, view(), {}, photos, 1).rgba, together.rgba);
}

TEST_F(Objects, NamesAreUniqueAndNumbersLimited) {
    const gl::HeadlessContext context;
    Renderer renderer(*first, MemoryBudget{});
    ObjectSet set(renderer, {scene[0]}, MemoryBudget{});
    set.add(scene[0]);
    EXPECT_EQ(set.at(1).name, "object0 2");
    SceneObject missing = scene[1];
    missing.package = dir / "none.vantage";
    EXPECT_THROW(set.add(missing), Error);
    EXPECT_EQ(set.size(), 2u);
}
