#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vantage {

/// How photos are grouped into bands: `auto`, `folders`, `off`, or the path of a file.
inline constexpr const char *bands_auto = "auto", *bands_by_folder = "folders", *bands_off = "off";

/// Whether `how` is the path of a file.
bool is_bands_file(const std::string& how);

/// Whether folders of this name are known to hold the photos of a band: visible, infrared, uvf, raking,
/// before and others, in upper or lower case.
bool is_known_band(const std::string& folder);

/// The bands of some photos.
struct BandGroups {
    std::vector<std::string> names;  ///< the default one first; a single one may have no name
    std::vector<std::uint32_t> of_photo;
    std::string note{};  ///< why folders that look like bands are none; may be empty
};

/// Groups photos, given by their paths in the photos' folder. `auto`: by the first folder in a photo's path
/// that is_known_band(), if all photos in folders have one; `folders`: by the first folder; photos in no
/// folder are the band `photos`. A file: TOML, a name and a pattern, or a list of them, per band:
///
///     visible = "*_vis.jpg"
///     infrared = ["ir/*", "nir_??.tif"]
///
/// A pattern has * and ? and is matched with the whole path, or without a / with the file's name. Bands of
/// visible light come first, then those with more photos. Throws Error(input) if the file cannot be read, a
/// band has no photo, or a photo no band or two; Error(usage) for more than 64 bands or for a name that
/// no folder may have.
BandGroups group_bands(std::span<const std::filesystem::path> photos, const std::string& how);

/// The folder in `path`, a path in `root`, whose photos are a band of their own; empty if there is none.
std::filesystem::path band_folder(const std::filesystem::path& root, const std::filesystem::path& path,
                                  const std::string& how);

}  // namespace vantage
