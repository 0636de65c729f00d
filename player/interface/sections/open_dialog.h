#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// A dialog to open a package or a scene file: lists folders and files, and accepts any path or URL.
class OpenDialog {
  public:
    /// `start`: the folder listed first.
    explicit OpenDialog(std::filesystem::path start) : start_(std::move(start)) {}
    void show(Controls& controls, WindowState& window);

  private:
    struct Entry {
        std::string label;  ///< folders end with a slash
        std::filesystem::path path;
        bool folder;
    };
    void list(const std::filesystem::path& folder);
    void select(std::size_t entry);
    void content(Controls& controls, WindowState& window);
    void entries(Controls& controls, WindowState& window);
    void move_by_keys(WindowState& window);
    void accept(WindowState& window);

    std::filesystem::path start_, folder_;
    std::vector<Entry> entries_;
    std::string trouble_;       ///< error while listing the folder
    std::size_t selected_ = 0;  ///< entries_.size(): none
    std::array<char, 4096> typed_{};
    int texts_ = 0;  ///< counts changes by the program, which an active text field would ignore
    bool focus_ = false, scroll_ = false, closes_ = false;
};

}  // namespace vantage
