#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

struct ImFontAtlas;

namespace vantage {

/// Text for pictures that are not a window's, in the font of panels.
class PictureText {
  public:
    /// `line`: height of a line, pixels, at least 1.
    explicit PictureText(int line);
    ~PictureText();

    int line() const { return line_; }
    /// Of a line of UTF-8, pixels, rounded up.
    int width(const std::string& text) const;
    /// Calls `put` for each pixel of a line whose upper left corner is at (x, y), with the share of the pixel
    /// that is covered, 1 to 255; also beside the picture.
    void draw(const std::string& text, int x, int y,
              const std::function<void(int x, int y, std::uint8_t covered)>& put) const;

  private:
    int line_;
    std::unique_ptr<ImFontAtlas> fonts_;
};

}  // namespace vantage
