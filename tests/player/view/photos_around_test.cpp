#include "player/view/photos_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/player/test_scene.h"

using namespace vantage;
using Eigen::Vector3d;

TEST(PhotosAround, GoToTheRightOnceAround) {
    std::vector<package::PhotoRecord> photos;
    for (const int step : {4, 0, 6, 2, 7, 1, 5, 3}) {
        const double turn = step * std::numbers::pi / 4;
        photos.push_back(
            photo_at({5 * std::cos(turn), 5 * std::sin(turn), 1.0 + step}, Eigen::Matrix3d::Identity()));
    }
    std::vector<std::uint32_t> order = photos_around(photos, {0, 0, 2});
    std::ranges::rotate(order, std::ranges::find(order, 1u));
    // Counterclockwise as seen from above is to the right for a viewer who faces inward.
    EXPECT_EQ(order, (std::vector<std::uint32_t>{1, 5, 3, 7, 0, 6, 2, 4}));
}

TEST(PhotosAround, OnTheAxisStayInFileOrder) {
    const std::vector<package::PhotoRecord> photos(3, photo_at({0, 0, 3}, Eigen::Matrix3d::Identity()));
    EXPECT_EQ(photos_around(photos, Vector3d::UnitZ()), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_TRUE(photos_around({}, Vector3d::UnitZ()).empty());
}
