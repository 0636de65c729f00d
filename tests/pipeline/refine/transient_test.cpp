#include "pipeline/refine/transient.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vantage;

namespace {

constexpr int width = 48, height = 32, cx = width / 2, cy = height / 2;

/// A photo of a gray plane, always taken from the same position. Within `radius` texels of its center, the
/// photo shows `light`.
TransientView view(float light = 0.2f, int radius = 0) {
    CoarsePhoto photo;
    photo.k = {width, height, 40, 40, cx, cy};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float c = std::hypot(x - cx, y - cy) < radius ? light : 0.2f;
            photo.texels.push_back({{c, c, c}, {c, c, c}, 10, 1});
        }
    return transient_view(photo);
}

int weight_in_the_middle(const TransientView& photo, std::vector<TransientView> others) {
    std::vector<const TransientView*> pointers;
    for (const TransientView& o : others) pointers.push_back(&o);
    const TransientMap map = transient_of(photo, pointers);
    EXPECT_EQ(map.weight.at(0), 255) << "the rest is the same in all photos";
    return map.weight.at(std::size_t(cy) * width + cx);
}

}  // namespace

TEST(TransientMasks, ColorInOnePhotoOnlyIsContradicted) {
    EXPECT_EQ(weight_in_the_middle(view(0.9f, 6), {view(), view(), view(), view()}), 0);
}

TEST(TransientMasks, ColorThatOneOtherPhotoShowsIsKept) {
    EXPECT_EQ(weight_in_the_middle(view(0.9f, 6), {view(), view(), view(), view(0.8f, 6)}), 255);
    EXPECT_EQ(weight_in_the_middle(view(0.9f, 6), {view(), view(), view(), view(0.02f, 6)}), 0)
        << "a different color does not confirm the first one";
}

TEST(TransientMasks, TwoOthersThatDifferContradictNothing) {
    EXPECT_EQ(weight_in_the_middle(view(0.9f, 6), {view(), view(0.02f, 6)}), 255);
}
