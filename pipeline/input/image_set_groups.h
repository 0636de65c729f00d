#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vantage {

/// The method of grouping photos into image sets is `auto`, `folders`, `off`, or the path of a file.
inline constexpr const char *image_sets_auto = "auto", *image_sets_by_folder = "folders",
                            *image_sets_off = "off";

/// Whether `how` is the path of a file.
bool is_image_sets_file(const std::string& how);

/// Whether a folder with this name is known to hold the photos of an image set: visible, infrared, uvf,
/// raking, before and others, in upper or lower case.
bool is_known_image_set(const std::string& folder);

/// The image sets of some photos.
struct ImageSetGroups {
    std::vector<std::string> names;  ///< the default image set first; a single image set may have no name
    std::vector<std::uint32_t> of_photo;
    std::string note{};  ///< the reason why folders that look like image sets are not used; may be empty
};

/// Groups photos, given by their paths in the photos' folder. If `how` is `auto`, the image set of a photo is
/// the first folder in its path for which is_known_image_set() is true, provided that all photos in folders
/// have such a folder. If `how` is `folders`, it is the first folder, and photos outside any folder form the
/// image set `photos`. Otherwise, `how` is the path of a TOML file with a name and a pattern, or a list of
/// patterns, per image set:
///
///     visible = "*_vis.jpg"
///     infrared = ["ir/*", "nir_??.tif"]
///
/// A pattern may contain * and ? and is matched against the whole path or, if it has no /, against the file's
/// name. Image sets of visible light come first, then those with more photos. Throws Error(input) if the file
/// cannot be read, if an image set has no photo, or if a photo has no image set or more than one. Throws
/// Error(usage) if there are more than 64 image sets, or if a name cannot be the name of a folder.
ImageSetGroups group_image_sets(std::span<const std::filesystem::path> photos, const std::string& how);

/// The folder in `path` whose photos form a separate image set; empty if there is none. `path` must be in
/// `root`.
std::filesystem::path image_set_folder(const std::filesystem::path& root, const std::filesystem::path& path,
                                       const std::string& how);

}  // namespace vantage
