#include "player/interface/tour/qr_code.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace vantage;

namespace {

/// Reads a QR code of version 2 (25 x 25 modules) with one block of bytes, without correcting errors
/// (ISO/IEC 18004).
std::string text_in(const QrCode& code) {
    constexpr int size = 25;
    const auto is_function = [](int x, int y) {
        return (x < 9 && (y < 9 || y >= size - 8)) || (x >= size - 8 && y < 9) || x == 6 || y == 6 ||
               (std::abs(x - 18) <= 2 && std::abs(y - 18) <= 2);
    };
    int mask = 0;  // bits 12 to 10 of the format
    for (int x = 2; x < 5; ++x) mask = 2 * mask + int(code.dark(x, 8));
    mask ^= 0b101;
    const auto inverted = [&](int x, int y) {
        const int i = y, j = x;
        const bool by_mask[] = {(i + j) % 2 == 0,
                                i % 2 == 0,
                                j % 3 == 0,
                                (i + j) % 3 == 0,
                                (i / 2 + j / 3) % 2 == 0,
                                i * j % 2 + i * j % 3 == 0,
                                (i * j % 2 + i * j % 3) % 2 == 0,
                                ((i + j) % 2 + i * j % 3) % 2 == 0};
        return by_mask[mask];
    };
    std::vector<bool> bits;
    bool up = true;
    for (int right = size - 1; right > 0; right -= 2, up = !up) {
        if (right == 6) --right;  // the timing pattern
        for (int step = 0; step < size; ++step)
            for (const int x : {right, right - 1}) {
                const int y = up ? size - 1 - step : step;
                if (!is_function(x, y)) bits.push_back(code.dark(x, y) != inverted(x, y));
            }
    }
    std::size_t at = 0;
    const auto number = [&](int count) {
        int out = 0;
        while (count-- > 0) out = 2 * out + int(bits.at(at++));
        return out;
    };
    if (number(4) != 0b0100) return "not bytes";
    std::string out;
    for (int left = number(8); left > 0; --left) out += char(number(8));
    return out;
}

}  // namespace

TEST(QrCode, ContainsItsText) {
    for (const std::string text : {"https://example.org/chapel", "HTTPS://MUSEUM.EXAMPLE/07"}) {
        const QrCode code = qr_code(text);
        ASSERT_EQ(code.size, 25);
        EXPECT_EQ(text_in(code), text);
    }
}

TEST(QrCode, OfALongerTextIsLargerOrEmpty) {
    EXPECT_GT(qr_code("https://example.org/" + std::string(400, 'a')).size, 57);
    EXPECT_EQ(qr_code(std::string(2400, 'a')).size, 0);
}
