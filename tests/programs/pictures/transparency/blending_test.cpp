// Compares transparent surfaces with ray casting and blending in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/gl/context.h"
#include "shaders/contract.h"
#include "tests/bench/painter/bsp_tree.h"
#include "tests/bench/painter/transparent_layers.h"
#include "tests/programs/pictures/transparency/transparent_scene.h"

using namespace vantage;

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

/// The largest distance between fragments of coplanar triangles that can result from rounding of the corners.
constexpr double one_plane = 3e-6;

/// Whether the order of fragments depends on rounding because, at the pixel, planes cross each other or the
/// opaque surface.
bool crosses(std::vector<TransparentLayers::Fragment> fragments, double opaque) {
    std::ranges::sort(fragments, {}, &TransparentLayers::Fragment::z);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        if (std::abs(fragments[i].z - opaque) < 1e-3) return true;
        const double apart = i > 0 ? fragments[i].z - fragments[i - 1].z : 1;
        if (apart > one_plane && apart < 1e-4) return true;
    }
    return false;
}

/// Gives coplanar fragments the same distance, so that they have the same order as the triangles.
void tie(std::vector<TransparentLayers::Fragment>& fragments) {
    std::ranges::sort(fragments, {}, &TransparentLayers::Fragment::z);
    for (std::size_t i = 1; i < fragments.size(); ++i)
        if (fragments[i].z - fragments[i - 1].z <= one_plane) fragments[i].z = fragments[i - 1].z;
}

}  // namespace

TEST_F(Transparent, ExactBlendingIsThatOfSortedFragments) {
    for (const auto& [max_alpha, inclined] :
         {std::pair(255, false), std::pair(40, false), std::pair(255, true)}) {
        ground();
        scatter(560, max_alpha, inclined);
        const PackageReader package =
            prepared(std::string(inclined ? "inclined" : "facing") + std::to_string(max_alpha));
        ASSERT_TRUE(effect_on(package.scene(), Effect::transparency));
        const gl::HeadlessContext context;
        Renderer renderer(package, MemoryBudget{});
        // The lists have space for 4 layers per pixel on average, so 64 layers can cover only a part
        // of the frame.
        const View view = facing(package, 75, 200, 200);
        const FrameReport report = taken(renderer, view, shown_as(Transparency::exact)).report;
        ASSERT_EQ(report.fragments_approximated, 0u) << "of " << report.fragments;
        const auto exact = light(renderer, view, shown_as(Transparency::exact));
        const auto approximate = light(renderer, view, shown_as(Transparency::approximate));
        const auto behind = light(renderer, view, shown_as(Transparency::off));
        auto pixels = TransparentLayers(package).fragments(view);
        const std::vector<double> opaque = opaque_depth(package, view);
        std::size_t most = 0, compared = 0, tied = 0, hidden = 0;
        double worst = 0, approximation = 0, worst_approximation = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            auto& f = pixels[i].fragments;
            if (f.empty() || pixels[i].edge || crosses(f, opaque[i])) continue;
            hidden += std::erase_if(f, [&](const auto& one) { return one.z > opaque[i]; });
            most = std::max(most, f.size());
            if (f.size() > std::size_t(shader::max_sorted_fragments)) continue;
            tie(f);
            for (std::size_t j = 1; j < f.size(); ++j) tied += f[j].z == f[j - 1].z;
            const Vector4d expected = blended(f, behind[i]);
            ++compared;
            worst = std::max(worst, codes_apart(exact[i], expected));
            const double off = codes_apart(approximate[i], expected);
            approximation += off, worst_approximation = std::max(worst_approximation, off);
        }
        EXPECT_GT(compared, 1500u);
        EXPECT_GT(most, 44u);
        EXPECT_LE(most, 64u);
        EXPECT_GT(tied, 1000u) << "coplanar triangles";
        EXPECT_GT(hidden, 1000u) << "behind the wall";
        EXPECT_LE(worst, 1.0) << "codes of 8 bits";
        approximation /= double(compared);
        std::printf(
            "%s, alpha up to %d: exact: error at most %.3f codes; approximate: mean error %.1f, largest %.1f "
            "codes\n",
            inclined ? "inclined" : "facing", max_alpha, worst, approximation, worst_approximation);
        EXPECT_GT(approximation, 0.5) << "the approximation should be distinguishable from the exact result";
        EXPECT_LT(approximation, 45);
    }
}

TEST_F(Transparent, ExactBlendingIsThatOfThePaintersAlgorithm) {
    ground();
    scatter(24, 255, false);
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = facing(package);
    const auto exact = light(renderer, view, shown_as(Transparency::exact));
    auto painted = light(renderer, view, shown_as(Transparency::off));
    const TransparentLayers layers(package);
    const auto pixels = layers.fragments(view);
    const std::vector<double> opaque = opaque_depth(package, view);
    const auto triangles = layers.triangles();
    const BspTree tree(triangles);
    ASSERT_TRUE(tree.complete());
    EXPECT_GT(tree.polygons(), 2 * triangles.size()) << "crossing triangles should be split";
    const Intrinsics& k = view.intrinsics;
    tree.back_to_front(view.cam_from_origin.center(), [&](const PaintedPolygon& p) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Eigen::Vector2d at(double(i % std::size_t(k.width)) + 0.5,
                                     double(i / std::size_t(k.width)) + 0.5);
            const auto f = std::ranges::find(pixels[i].fragments, p.triangle + layers.first(),
                                             &TransparentLayers::Fragment::triangle);
            if (f == pixels[i].fragments.end() || f->z > opaque[i]) continue;
            // A point is inside the piece if it is on the same side of all its edges.
            const Vector3d ray = view.cam_from_origin.R.transpose() *
                                 Vector3d((at.x() - k.cx) / k.fx, (at.y() - k.cy) / k.fy, 1),
                           eye = view.cam_from_origin.center();
            int left = 0, right = 0;
            for (std::size_t c = 0; c < p.corners.size(); ++c) {
                const Vector3d a = p.corners[c] - eye, b = p.corners[(c + 1) % p.corners.size()] - eye;
                const double side = a.cross(b).dot(ray);
                left += side > 0, right += side < 0;
            }
            if (left > 0 && right > 0) continue;
            painted[i].head<3>() = f->alpha * f->color + (1 - f->alpha) * painted[i].head<3>();
            painted[i][3] = f->alpha + (1 - f->alpha) * painted[i][3];
        }
    });
    std::size_t compared = 0, wrong = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i].edge || pixels[i].fragments.empty() || crosses(pixels[i].fragments, opaque[i]))
            continue;
        ++compared;
        wrong += codes_apart(exact[i], painted[i]) > 1;
    }
    EXPECT_GT(compared, 5000u);
    EXPECT_LE(double(wrong), 0.001 * double(compared)) << "only pixels at cuts between pieces may differ";
}

TEST_F(Transparent, WhatFindsNoRoomIsApproximatedAndCounted) {
    ground();
    for (int i = 0; i < 100; ++i)
        add_quad({-0.7, -3 + 0.02 * i, 1.8}, {1.4, 0, 0}, {0, 0, 1.4},
                 {std::uint8_t(i * 2), 200, std::uint8_t(255 - i), 12});
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    const auto pixels = TransparentLayers(package).fragments(facing(package));
    const auto behind = [&] {
        Renderer renderer(package, MemoryBudget{});
        return light(renderer, facing(package), shown_as(Transparency::off));
    }();
    const auto mean_error = [&](Renderer& renderer) {
        const auto shown = light(renderer, facing(package), shown_as(Transparency::exact));
        double sum = 0;
        std::size_t compared = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (pixels[i].fragments.size() < 80 || pixels[i].edge) continue;
            sum += codes_apart(shown[i], blended(pixels[i].fragments, behind[i]));
            ++compared;
        }
        EXPECT_GT(compared, 400u);
        return sum / double(compared);
    };
    {
        Renderer renderer(package, MemoryBudget{});
        EXPECT_LT(mean_error(renderer), 1.5) << "surfaces behind 64 layers should hardly be visible";
        const FrameReport r = taken(renderer, facing(package), shown_as(Transparency::exact)).report;
        EXPECT_GT(r.fragments, 50'000u);
        std::size_t deep = 0;
        for (const auto& pixel : pixels) deep += std::max<std::size_t>(pixel.fragments.size(), 64) - 64;
        EXPECT_NEAR(double(r.fragments_approximated), double(deep), 0.03 * double(deep));
        const FrameReport four = taken(renderer, facing(package), shown_as(Transparency::exact), 2).report;
        EXPECT_NEAR(double(four.fragments), 4.0 * double(r.fragments), 0.02 * double(r.fragments))
            << "of all samples";
    }
    // From a shorter distance, the stack fills the frame.
    Renderer renderer(package, MemoryBudget{});
    const View near = facing(package, 5);
    const auto shown = light(renderer, near, shown_as(Transparency::exact)),
               approximate = light(renderer, near, shown_as(Transparency::approximate));
    const FrameReport r = taken(renderer, near, shown_as(Transparency::exact)).report;
    EXPECT_GT(r.fragments_approximated, r.fragments * 9 / 10);
    for (std::size_t i = 0; i < shown.size(); ++i)
        ASSERT_LT(codes_apart(shown[i], approximate[i]), 60) << "approximate, not missing";
    const std::string says = (dir / "says").string();
    const std::string command = std::string(VANTAGE_PLAYER) + " render " + package.path().string() +
                                " --size 64x48 --view 0,-14,2.5,0,0,2.5,5 -o " + says + ".png >" + says +
                                " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_NE(slurp(says).find("transparent fragments are approximated"), std::string::npos) << slurp(says);
}
