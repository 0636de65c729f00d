#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace vantage {

/// Finds photos' masks, pictures that are dark where a photo must not be shown: NAME.mask.png beside the
/// photo, or NAME.png in `masks` beside the photo's folder, or in a subfolder with the name of the photo's
/// folder in `masks` one level higher. NAME is the photo's, with or without its extension; names are compared
/// as by comparable_name(). Lists each folder once.
class Masks {
  public:
    /// Empty: the photo has none.
    std::filesystem::path of(const std::filesystem::path& photo);

  private:
    std::filesystem::path find(const std::filesystem::path& folder, const std::string& name);

    std::map<std::filesystem::path, std::map<std::string, std::filesystem::path>>
        folders_;  ///< by comparable name
};

}  // namespace vantage
