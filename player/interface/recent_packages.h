#pragma once
#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "base/gl/object.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/user_command.h"

namespace vantage {

/// The recently opened packages and scene files, with the thumbnails of their first photos. Must be used on
/// the OpenGL thread.
class RecentPackages {
  public:
    /// `files`: most recent first.
    explicit RecentPackages(std::span<const std::string> files);
    /// Shows as many of them as fit into an area of this size; a click opens one.
    void show(Controls& controls, UserCommands& commands, ImVec2 room) const;
    /// Loads the next picture; returns false if all were loaded. Packages on servers, and those that are
    /// missing or damaged, have none.
    bool load_next();

  private:
    struct Card {
        std::string file;
        gl::Texture picture{};
        ImVec2 size{};  ///< of the picture
    };
    static void show(Controls& controls, UserCommands& commands, const Card& card, ImVec2 picture);

    std::vector<Card> cards_;
    std::size_t loaded_ = 0;  ///< cards whose picture was loaded, or is absent
};

}  // namespace vantage
