#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/measure/evaluation/held_out.h"

namespace vantage {

/// Writes index.html: one row per photo; the causes of the error; the changes since an earlier evaluation
/// with crops NAME-worse.png and NAME-better.png; and the pictures NAME-photo.png, NAME-rendered.png,
/// NAME-difference.png and NAME-causes.png, the `worst` photos (by SSIM) first and larger. Throws
/// Error(storage).
void write_evaluation_page(const std::filesystem::path& folder, const std::string& title,
                           const std::vector<PhotoEvaluation>& results, int worst);

/// Indices of the photos that are also in an earlier evaluation, by decreasing loss (dB after gains).
std::vector<std::size_t> by_change(const std::vector<PhotoEvaluation>& results);

/// Indices by increasing SSIM; photos without colored pixels come first.
std::vector<std::size_t> worst_first(const std::vector<PhotoEvaluation>& results);

}  // namespace vantage
