#include "pipeline/reports/page/base64.h"

#include <algorithm>
#include <cstdint>

namespace vantage {

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t j = 0; j < 3; ++j)
            word = word << 8 | (j < here ? std::uint8_t(bytes[i + j]) : std::uint32_t(0));
        for (std::size_t j = 0; j < 4; ++j) out += j <= here ? digits[word >> (18 - 6 * j) & 63] : '=';
    }
    return out;
}

}  // namespace vantage
