#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/text/located_json.h"

namespace vantage {

/// A JSON file of cameras. Unknown keys are ignored.
class JsonFile {
  public:
    /// Throws Error(input) if the file cannot be read or is not JSON.
    explicit JsonFile(const std::filesystem::path& file);
    LocatedJson root() { return {name_, *value_, unknown_}; }

  private:
    std::string name_;
    std::shared_ptr<const nlohmann::json> value_;
    std::vector<std::string> unknown_;
};

/// The maximum length of a list of cameras.
inline constexpr std::size_t max_cameras = 1 << 20;
/// The largest magnitude of positions, focal lengths and pixels.
inline constexpr double max_value = 1e12;

/// A finite number, possibly stored as a string.
double numeral(const LocatedJson& value);
/// The number stored under a key, or `otherwise` if the key is missing.
double numeral(const LocatedJson& object, const char* key, double otherwise);
/// The width or height of a photo.
int photo_size(const LocatedJson& value);
/// A list of numbers; throws unless there are `count` of them.
std::vector<double> numerals(const LocatedJson& list, std::size_t count);
/// A number or a string that serves as an identifier.
std::string identifier(const LocatedJson& value);

}  // namespace vantage
