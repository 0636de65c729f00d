#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vantage {

/// A file name without its extension.
std::string_view stem_of(std::string_view name);

/// The indices of the photos that a user means by `wanted`: the one of exactly this name, otherwise those of
/// this name without extension, otherwise those whose comparable_name() is the same, with or without
/// extension. More than one: `wanted` is ambiguous.
std::vector<std::size_t> photos_meant(std::span<const std::string_view> names, std::string_view wanted);

/// "0000.jpg and 0000.png": for a message about an ambiguous name.
std::string listed(std::span<const std::string_view> names, std::span<const std::size_t> indices);

/// The name of each photo in the names of files made from it: without extension if that tells it from all
/// other photos, otherwise in full. No two are equal if no two of `names` are.
std::vector<std::string> file_stems(std::span<const std::string_view> names);

/// Whether an image set may have this name: 1 to 55 bytes that name a folder, without controls or
/// '='.
bool is_image_set_name(std::string_view name);

}  // namespace vantage
