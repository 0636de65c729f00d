#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/measure/left_out.h"

namespace vantage {

/// index.html: the means, a row for each photo, and the pictures NAME-photo.png, NAME-rendered.png,
/// NAME-difference.png beside it, the `worst` ones (by SSIM) first and larger, and what
/// has changed since an earlier evaluation with crops NAME-worse.png, NAME-better.png. Throws Error(storage).
void write_evaluation_page(const std::filesystem::path& folder, const std::string& title,
                           const std::vector<LeftOut>& results, int worst);

/// Indices of the photos that an earlier evaluation has, too, the greatest loss first (dB after gains).
std::vector<std::size_t> by_change(const std::vector<LeftOut>& results);

/// Indices by rising SSIM; photos that nothing shows come first.
std::vector<std::size_t> worst_first(const std::vector<LeftOut>& results);

}  // namespace vantage
