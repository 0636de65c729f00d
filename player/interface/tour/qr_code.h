#pragma once
#include <string>
#include <vector>

namespace vantage {

/// A QR code without its margin.
struct QrCode {
    int size = 0;               ///< modules per side; 0 if the text is too long
    std::vector<bool> modules;  ///< row by row; true is dark
    bool dark(int x, int y) const { return modules[std::size_t(y) * std::size_t(size) + std::size_t(x)]; }
};

/// The smallest code of a text (at most 2331 bytes) from which 15 % of the modules may be missing (level M).
QrCode qr_code(const std::string& text);

}  // namespace vantage
