#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// Why the first picture of a TIFF cannot be read rightly, although OpenImageIO reads it; empty: it can. Its
/// samples may have one bit by default, its colors may have a byte each instead of two, or the file may end
/// before its pixels. `file` must be a TIFF.
std::string tiff_flaw(const std::filesystem::path& file);

}  // namespace vantage
