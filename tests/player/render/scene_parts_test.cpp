// Checks which parts of a package each setting shows.
#include "player/render/scene_parts.h"

#include <gtest/gtest.h>

using namespace vantage;

namespace {

constexpr SceneParts everything{true, true, true, true}, only_points{false, true, true, false};

}  // namespace

TEST(SceneParts, APackageOfPointsShowsNothingElse) {
    RenderSettings settings;
    settings.points.show = false;
    settings.light.light = Light::raking;
    settings.field.index = 2;
    EXPECT_EQ(usable(settings, everything), settings);
    const RenderSettings used = usable(settings, only_points);
    EXPECT_TRUE(used.points.show && used.points.alone);
    EXPECT_EQ(used.light.light, Light::photos);
    EXPECT_EQ(used.field.index, -1);
}

TEST(SceneParts, PointsHavePhotosColorsWithoutAMesh) {
    RenderSettings settings;
    EXPECT_FALSE(photos_on_points(settings, everything));
    EXPECT_TRUE(photos_on_points(settings, only_points));
    settings.points.color = PointColor::photos;
    EXPECT_TRUE(photos_on_points(settings, everything));
    EXPECT_FALSE(photos_on_points(settings, {.mesh = true, .photos = true}));
}

TEST(SceneParts, PhotosAreNeededForWhatTheyShow) {
    constexpr SceneParts mesh{.mesh = true, .photos = true};
    RenderSettings settings;
    EXPECT_TRUE(shows_photos(settings, mesh));
    settings.light.light = Light::lamp;
    EXPECT_FALSE(shows_photos(settings, mesh));
    EXPECT_TRUE(shows_photos(settings, everything)) << "background";
    settings.light.on_photos = true;
    EXPECT_TRUE(shows_photos(settings, mesh));
    settings.light.light = Light::normals;
    EXPECT_FALSE(shows_photos(settings, mesh));
    settings.points.alone = true;
    EXPECT_FALSE(shows_photos(settings, everything));
}

TEST(SceneParts, HolesAreFilledInColorsWithBackgroundOnly) {
    RenderSettings settings;
    EXPECT_TRUE(fills_holes(settings, everything));
    EXPECT_FALSE(fills_holes(settings, {.mesh = true, .photos = true}));
    settings.show = Show::coverage;
    EXPECT_FALSE(fills_holes(settings, everything));
    settings.show = Show::colors;
    settings.points.alone = true;
    EXPECT_FALSE(fills_holes(settings, everything));
}
