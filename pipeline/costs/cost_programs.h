#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "pipeline/costs/costs.h"

namespace vantage {

/// The view of a photo, to be rendered at this size in px.
struct PhotoView {
    std::string photo;
    int width = 0, height = 0;
};

/// Runs `vantage` and `vantage-player` as a user would. Their output is kept in a folder.
class CostPrograms {
  public:
    /// Finds vantage-player beside this program, in a build tree, or in the PATH.
    explicit CostPrograms(std::filesystem::path folder);

    struct Prepared {
        double seconds = 0, memory_bytes = 0, package_bytes = 0;
    };
    /// Prepares the scan with these options, replacing the package. Throws Error.
    Prepared prepare(const std::string& scan, const std::filesystem::path& package,
                     const std::vector<std::string>& options) const;

    /// Renders these views into a folder. Returns the pictures' files, one per view. Throws Error.
    std::vector<std::filesystem::path> render(const std::string& package, std::span<const PhotoView> views,
                                              const std::vector<std::string>& options,
                                              const std::filesystem::path& folder) const;

    /// The median frame time of the opening view at 1280x720 with resident tiles, in ms. Throws Error.
    double frame_ms(const std::string& package, const std::vector<std::string>& options) const;

  private:
    /// Runs a program with --json and returns its results. Throws Error with the program's message and exit
    /// code.
    nlohmann::json results_of(std::vector<std::string> words) const;

    std::filesystem::path folder_, vantage_, player_;
};

}  // namespace vantage
