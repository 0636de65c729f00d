#include "scene/package/contents/scalar_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/text/error.h"

using namespace vantage;

TEST(ScalarField, RangesAreNeverEmpty) {
    for (const double at : {0.0, 1.0, -7.5, 1e30, -3e38, 1e-30}) {
        ScalarField field{.name = "constant", .values = {}};
        field.low = field.high = at;
        field.least_positive = std::max(at, 0.0);
        for (const bool centered : {false, true})
            for (const bool logarithmic : {false, true}) {
                const ValueRange r = whole_range(field, centered, logarithmic);
                EXPECT_LT(r.low, r.high) << at << centered << logarithmic;
                EXPECT_TRUE(std::isfinite(r.high - r.low)) << at;
                if (logarithmic) {
                    EXPECT_GT(r.low, 0) << at;
                }
            }
    }
}

TEST(ScalarField, ACenteredRangeHasZeroInTheMiddle) {
    ScalarField field{.name = "deviation", .values = {}};
    field.low = -0.2, field.high = 0.5;
    EXPECT_EQ(whole_range(field, true, false), (ValueRange{-0.5, 0.5}));
    EXPECT_EQ(whole_range(field, false, false), (ValueRange{-0.2, 0.5}));
}

TEST(ScalarField, AnUnknownNameListsThoseThereAre) {
    const std::vector<ScalarField> fields{{.name = "height", .values = {}},
                                          {.name = "deviation", .values = {}}};
    EXPECT_EQ(field_named(fields, "deviation"), 1);
    try {
        field_named(fields, "depth");
        ADD_FAILURE() << "accepted";
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(),
                     "no scalar field 'depth', expected one of height, deviation; 'vantage prepare SCAN -o "
                     "PACKAGE --deviation-from MESH' measures deviation-from-MESH, and the per-vertex "
                     "values of a PLY file are kept");
        EXPECT_EQ(e.code(), Exit::usage);
    }
}
