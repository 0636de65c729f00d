#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

struct ImFontAtlas;

namespace vantage {

/// Text for pictures rendered without a window, in the panels' font.
class PictureText {
  public:
    /// `line`: line height in pixels, at least 1.
    explicit PictureText(int line);
    ~PictureText();

    int line() const { return line_; }
    /// Width of a line of UTF-8 text in pixels, rounded up.
    int width(const std::string& text) const;
    /// Calls `put` for each covered pixel of a line whose upper left corner is at (x, y), with the pixel's
    /// coverage, 1 to 255. These pixels may lie outside the picture.
    void draw(const std::string& text, int x, int y,
              const std::function<void(int x, int y, std::uint8_t covered)>& put) const;

  private:
    int line_;
    std::unique_ptr<ImFontAtlas> fonts_;
};

}  // namespace vantage
