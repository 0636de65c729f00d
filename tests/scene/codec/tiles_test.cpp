#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "scene/codec/byte_planes.h"
#include "scene/codec/depth_values.h"
#include "scene/codec/zstd_bytes.h"
#include "shaders/contract.h"

using namespace vantage::codec;

namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const std::vector<float>& values) {
    Bytes out(values.size() * 4);
    std::memcpy(out.data(), values.data(), out.size());
    return out;
}

}  // namespace

TEST(BytePlanes, ComeBackAsTheyWere) {
    std::mt19937 random(1);
    for (const auto& [width, height] : {std::pair{1, 1}, {256, 256}, {3, 200}, {200, 1}})
        for (const int noise : {1, 4, 256}) {
            Bytes texels(std::size_t(width) * std::size_t(height) * 4);
            for (std::size_t i = 0; i < texels.size(); ++i)
                texels[i] = std::byte(i % 4 == 3 ? 255 : (i / 9 + random() % unsigned(noise)) & 255);
            Bytes back(texels.size());
            ASSERT_TRUE(decode_planes(encode_planes(texels, width, height), width, height, back));
            EXPECT_EQ(back, texels);
        }
}

TEST(BytePlanes, OneValueTakesHardlyAnySpace) {
    EXPECT_LT(encode_planes(Bytes(256 * 256 * 4, std::byte(200)), 256, 256).size(), 64u);
}

/// The depths range from the smallest to the largest float, and include infinity for the background.
TEST(DepthValues, AreKeptToATenthOfTheSlackOfVisibility) {
    EXPECT_LE(depth_error, 0.1 * double(vantage::shader::depth_slack));
    std::mt19937 random(1);
    std::uniform_real_distribution<float> shade(0, 1);
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float scale : {1e-30f, 1e-3f, 1.0f, 5e3f, 1e30f}) {
        std::vector<float> z;
        for (int i = 0; i < 64 * 50; ++i) z.push_back(i % 7 ? scale * (1 + 30 * shade(random)) : infinity);
        Bytes back(z.size() * 4);
        ASSERT_TRUE(decode_depth(encode_depth(bytes_of(z), 64, 50), 64, 50, back));
        for (std::size_t i = 0; i < z.size(); ++i) {
            float read;
            std::memcpy(&read, &back[4 * i], 4);
            ASSERT_EQ(std::isinf(read), std::isinf(z[i]));
            if (std::isinf(read)) continue;
            EXPECT_LE(std::abs(double(read) - double(z[i])), depth_error * double(z[i]));
            EXPECT_EQ(read, kept_depth(z[i]));
        }
    }
}

TEST(DepthValues, ExtremesStayPositiveAndFinite) {
    const float least = std::numeric_limits<float>::denorm_min(), most = std::numeric_limits<float>::max();
    for (const float z : {least, std::numeric_limits<float>::min(), most}) {
        EXPECT_GT(kept_depth(z), 0);
        EXPECT_TRUE(std::isfinite(kept_depth(z)));
    }
    EXPECT_TRUE(encode_depth(bytes_of({least, most}), 2, 1).empty());
    EXPECT_TRUE(encode_depth(bytes_of({1, std::nanf("")}), 2, 1).empty());
    EXPECT_TRUE(encode_depth(bytes_of({1, 0}), 2, 1).empty());
    EXPECT_TRUE(encode_depth(bytes_of({1, -2}), 2, 1).empty());
}

TEST(DepthValues, NothingSeenIsKept) {
    const std::vector<float> z(12, std::numeric_limits<float>::infinity());
    Bytes back(48);
    ASSERT_TRUE(decode_depth(encode_depth(bytes_of(z), 4, 3), 4, 3, back));
    EXPECT_EQ(back, bytes_of(z));
}

TEST(Codecs, RefuseWhatIsNotTheirs) {
    const Bytes coded = encode_depth(bytes_of(std::vector<float>(64, 3.f)), 8, 8);
    Bytes out(64 * 4);
    EXPECT_FALSE(decode_depth(std::span(coded).first(coded.size() / 2), 8, 8, out));
    EXPECT_FALSE(decode_depth({}, 8, 8, out));
    EXPECT_FALSE(decode_depth(coded, 8, 7, out));
    EXPECT_FALSE(decode_planes(coded, 8, 8, out));
    EXPECT_FALSE(decode_planes({}, 8, 8, out));
    // A large frame does not fit, and no memory may be allocated for it.
    const Bytes large = compress(Bytes(std::size_t(1) << 26), 1);
    EXPECT_FALSE(decompress(large, out));
    EXPECT_FALSE(decode_planes(large, 8, 8, out));
}
