#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/formats/cameras/cameras.h"

namespace vantage {

/// Whether the file's extension is that of a photo; false for masks (NAME.mask.png) and hidden files.
bool is_photo(const std::filesystem::path& file);

/// Whether a folder with this name holds pictures computed from photos: masks, depth, normals, thumbnails.
bool is_derived(const std::filesystem::path& folder);

/// The photos in a folder and two levels below it, sorted; subfolders of derived pictures are skipped.
std::vector<std::filesystem::path> photos_below(const std::filesystem::path& folder);

/// The file whose path in `folder` has this utf8_name(); if there is no such file, the path formed from the
/// name as given.
std::filesystem::path file_named(const std::filesystem::path& folder, const std::string& utf8);

/// The utf8_name() of a file's path in `folder`, or of the file if it is elsewhere.
std::string name_below(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The file or folder in `folder` with this utf8_name(), or the only one with this comparable_name(); empty
/// if there is none.
std::filesystem::path file_meant(const std::filesystem::path& folder, const std::string& name);

/// The photo of a camera.
struct PhotoMatch {
    std::filesystem::path file;  ///< empty: none
    bool by_name = false;        ///< whether the extension also matches the camera's
    std::size_t folders = 0;     ///< number of folders in common with the camera's name or group
    /// If `file` is empty, the files that fit equally well.
    std::vector<std::filesystem::path> candidates = {};
};

/// Finds the photo of each camera, whose name may include folders, among `photos` in `folder`. Names are
/// compared by comparable_name(). The file's path must contain all of the name's folders, or the name must
/// contain all of the file's folders below `folder`. A file that fits several names is assigned to none of
/// them. Of several files that fit a name, the one in folders named like the camera's group is chosen, or the
/// only one that no other camera refers to by its folder. If no file has the name's extension, one with
/// another extension is used.
std::vector<PhotoMatch> match_photos(const std::filesystem::path& folder,
                                     const std::vector<std::filesystem::path>& photos,
                                     std::span<const CameraSet::Entry> cameras);

/// The photos that have no camera: those of `photos` that are not in `used`, that are not next to a used
/// photo of the same name with another extension (RAW and JPEG), and whose folder has a used photo or is
/// `folder` itself.
std::vector<std::filesystem::path> unused_photos(const std::filesystem::path& folder,
                                                 const std::vector<std::filesystem::path>& photos,
                                                 const std::vector<std::filesystem::path>& used);

}  // namespace vantage
