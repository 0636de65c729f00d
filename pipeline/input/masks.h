#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace vantage {

/// Finds photos' masks: pictures that are dark where the photo must not be shown. A mask may be NAME.mask.png
/// next to the photo, NAME.png in a folder `masks` next to the photo's folder, or NAME.png in a folder
/// `masks` one level higher, in the subfolder with the same name as the photo's folder. NAME is the photo's
/// file name, with or without its extension; names are compared by comparable_name(). Lists each folder once.
class Masks {
  public:
    /// The mask of the photo; empty if it has none.
    std::filesystem::path of(const std::filesystem::path& photo);

  private:
    std::filesystem::path find(const std::filesystem::path& folder, const std::string& name);

    std::map<std::filesystem::path, std::map<std::string, std::filesystem::path>>
        folders_;  ///< by comparable name
};

}  // namespace vantage
