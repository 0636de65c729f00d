#include "player/plan/selection/weights.h"

#include <gtest/gtest.h>

#include <vector>

#include "player/view/view.h"
#include "tests/player/test_scene.h"

using namespace vantage;

TEST(Weights, NearestIsOneAndNoneIsZero) {
    const auto w = nearest_is_one({2, 1, 3});
    EXPECT_DOUBLE_EQ(w[1], 1);
    EXPECT_DOUBLE_EQ(w[0], 0.5);
    EXPECT_GT(w[2], 0);
    EXPECT_EQ(nearest_is_one({5, 5, 5}), std::vector<double>(3, 1.0));
    EXPECT_TRUE(nearest_is_one({}).empty());
}

TEST(Weights, AreFiniteAtEveryExponent) {
    Random random;
    const View view = random_view(random);
    std::vector<package::PhotoRecord> photos;
    for (int i = 0; i < 5; ++i) {
        const View v = random_view(random);
        photos.push_back(photo_at(v.cam_from_origin.center(), v.cam_from_origin.R));
    }
    photos.push_back(photo_at(view.cam_from_origin.center(), view.cam_from_origin.R));
    for (const double exponent : {0.0, 1.0, 64.0})
        for (const bool per_photo : {false, true}) {
            WeightSettings s;
            s.exponent = exponent;
            s.angle_per_photo = per_photo;
            s.fov_normalization = per_photo;
            const auto w = dynamic_weights(view, photos, s);
            for (const double x : w) EXPECT_TRUE(x > 0 && x <= 1) << x;
            if (!per_photo) {
                EXPECT_DOUBLE_EQ(w.back(), 1) << "the photo at the viewpoint has full weight";
            }
        }
}

TEST(Weights, FieldOfViewMovesATelephotoCameraCloser) {
    // Two cameras on a line; the one farther away has half the field of view and sees the same extent.
    package::PhotoRecord wide = photo_at({0, 0, -10}, Eigen::Matrix3d::Identity());
    package::PhotoRecord tele = photo_at({0, 0, -20}, Eigen::Matrix3d::Identity());
    wide.seen_distance = 10;
    tele.seen_distance = 20;
    tele.fx = tele.fy = 2 * wide.fx;
    View view = view_of_photo(wide, 1);
    WeightSettings s;
    s.fov_normalization = true;
    const auto w = dynamic_weights(view, std::vector{wide, tele}, s);
    EXPECT_NEAR(w[1], 1, 1e-9)
        << "at the distance d' = d tan(f/2) / tan(f'/2), the photo is at the viewpoint";
}
