#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// A file name without its extension.
std::string_view stem_of(std::string_view name);

/// The indices of the photos that a user means by `wanted`. The result is the exact match if there is one,
/// otherwise the names that match without the extension, otherwise the names with the same comparable_name(),
/// with or without the extension. If there are several indices, `wanted` is ambiguous.
std::vector<std::size_t> photos_meant(std::span<const std::string_view> names, std::string_view wanted);

/// "0000.jpg and 0000.png", for a message about an ambiguous name.
std::string listed(std::span<const std::string_view> names, std::span<const std::size_t> indices);

/// The first `most` names, such as "a, b and 4 more", for a message about many names.
std::string first_of(std::span<const std::string> names, std::size_t most);

/// The stem of each photo's output files: its name without the extension if that is unique, otherwise its
/// full name. The stems are unique if `names` are unique.
std::vector<std::string> file_stems(std::span<const std::string_view> names);

/// Whether an image set may have this name: a valid folder name of 1 to 55 bytes without control characters
/// or '='.
bool is_image_set_name(std::string_view name);

}  // namespace vantage
