// Compares jump flooding with the exact transform on the depth borders of real photos, and prints one row per
// variant.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/stages/borders.h"
#include "pipeline/visibility/border_distance.h"
#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/photo_geometry.h"
#include "tests/datasets.h"

using namespace vantage;

namespace {

struct Borders {
    int width, height;
    float full_width;  ///< width of the ramp of the border weight, in map pixels
    std::vector<std::uint8_t> pixels;
};

/// The borders that prepare finds in each photo.
std::vector<Borders> borders_of(const std::filesystem::path& input) {
    const SceneInput scene = read_scene(discover(input));
    std::vector<Eigen::Vector3f> positions;
    for (const Eigen::Vector3d& p : scene.mesh.positions) positions.push_back(p.cast<float>());
    std::vector<std::uint32_t> indices;
    for (const auto& t : scene.mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    const ModelBuffers model = upload_model(positions, scene.mesh.normals);
    std::vector<Borders> all;
    for (const PhotoInput& photo : scene.photos) {
        const Intrinsics& k = photo.camera.intrinsics;
        const Pose& pose = photo.camera.cam_from_world;
        PhotoGeometry g = render_geometry(model, indices, k, pose, depth_range(positions, pose));
        const DepthMap depth{g.width, g.height, std::move(g.z), {}};
        all.push_back({g.width, g.height, float(border_width * k.width / 3072 / 2),
                       find_borders(depth, float(border_threshold))});
    }
    return all;
}

struct Accuracy {
    std::size_t wrong = 0, pixels = 0;
    double worst = 0, seconds = 0;
    int worst_weight = 0;
};

Accuracy measure(const std::vector<Borders>& all) {
    Accuracy a;
    const gl::Program jump_flood = jump_flood_program();
    for (const Borders& b : all) {
        const auto truth = exact_distance(b.pixels, b.width, b.height);
        const auto start = std::chrono::steady_clock::now();
        const auto found = flood_distance(jump_flood, b.pixels, b.width, b.height);
        a.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const auto weight_truth = border_weights(truth, b.width, b.height, b.full_width),
                   weights = border_weights(found, b.width, b.height, b.full_width);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double error = std::abs(double(found[i]) - double(truth[i]));
            a.wrong += error > 1e-3;
            a.worst = std::max(a.worst, error);
            a.worst_weight = std::max(a.worst_weight, std::abs(int(weights[i]) - int(weight_truth[i])));
        }
        a.pixels += truth.size();
    }
    return a;
}

void compare_on(const char* set) {
    VANTAGE_DATASET(input, set);
    const gl::HeadlessContext context(gl::Debug::on);
    const std::vector<Borders> all = borders_of(input);
    const Accuracy a = measure(all);
    std::printf("%-12s %.5f %% wrong, largest error %.3f px (border weight: %d/255), %.0f ms per photo\n",
                set, 100 * double(a.wrong) / double(a.pixels), a.worst, a.worst_weight,
                1000 * a.seconds / double(all.size()));
    EXPECT_LT(double(a.wrong), 0.01 * double(a.pixels));
    EXPECT_LE(a.worst_weight, 2);
}

}  // namespace

TEST(BorderAccuracyAtLength, JumpFloodingOnSceaux) { compare_on("sceaux"); }
TEST(BorderAccuracyAtLength, JumpFloodingOnFountain) { compare_on("fountain-P11"); }
