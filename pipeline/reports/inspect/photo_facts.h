#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/photos/image_files.h"

namespace vantage {

/// Photos of one file format and size.
struct PhotoGroup {
    std::string format;  ///< see format_of()
    PhotoSize size;      ///< size as stored; 0 x 0 if the headers cannot be read
    std::size_t photos = 0;
    std::uint64_t bytes = 0;  ///< of the files
};

/// The photos in a folder, regardless of whether they have a camera.
struct PhotoFacts {
    std::vector<PhotoGroup> groups;  ///< groups with the most photos first
    std::vector<UnusablePhoto> unreadable;
    std::size_t masks = 0;  ///< number of photos with a mask

    std::size_t photos() const;
    std::uint64_t bytes() const;
    double pixels() const;
};

/// Reads the photos' headers. Throws Error(input) if the folder cannot be read.
PhotoFacts photo_facts(const std::filesystem::path& folder);

}  // namespace vantage
