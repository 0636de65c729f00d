#include "scene/package/contents/scalar_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/text/error.h"

using namespace vantage;

TEST(ScalarField, RangesAreNeverEmpty) {
    for (const double at : {0.0, 1.0, -7.5, 1e30, -3e38, 1e-30}) {
        ScalarField layer{.name = "constant", .values = {}};
        layer.low = layer.high = at;
        layer.least_positive = std::max(at, 0.0);
        for (const bool centered : {false, true})
            for (const bool logarithmic : {false, true}) {
                const ValueRange r = whole_range(layer, centered, logarithmic);
                EXPECT_LT(r.low, r.high) << at << centered << logarithmic;
                EXPECT_TRUE(std::isfinite(r.high - r.low)) << at;
                if (logarithmic) {
                    EXPECT_GT(r.low, 0) << at;
                }
            }
    }
}

TEST(ScalarField, ACenteredRangeHasZeroInTheMiddle) {
    ScalarField layer{.name = "deviation", .values = {}};
    layer.low = -0.2, layer.high = 0.5;
    EXPECT_EQ(whole_range(layer, true, false), (ValueRange{-0.5, 0.5}));
    EXPECT_EQ(whole_range(layer, false, false), (ValueRange{-0.2, 0.5}));
}

TEST(ScalarField, AnUnknownNameListsThoseThereAre) {
    const std::vector<ScalarField> layers{{.name = "height", .values = {}},
                                          {.name = "deviation", .values = {}}};
    EXPECT_EQ(layer_named(layers, "deviation"), 1);
    try {
        layer_named(layers, "depth");
        ADD_FAILURE() << "accepted";
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "no scalar field 'depth', expected one of height, deviation");
        EXPECT_EQ(e.code(), Exit::usage);
    }
}
