#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// The reason why OpenImageIO reads the first picture of a TIFF incorrectly; empty if the result is correct.
/// The picture's samples may have one bit by default, its color map may have one byte per value instead of
/// two, or the file may end before its pixels. `file` must be a TIFF.
std::string tiff_flaw(const std::filesystem::path& file);

}  // namespace vantage
