#pragma once
#include <cstdint>
#include <filesystem>
#include <future>
#include <span>

#include "base/gl/object.h"
#include "player/render/picture.h"

namespace vantage {

/// Reads a PNG or JPEG file of at most 64 MiB and 40 megapixels. Throws Error(input) naming the file.
Picture read_note_picture(const std::filesystem::path& file);

/// Reduces a picture by integer factors until neither side exceeds `most` pixels.
Picture reduced_picture(Picture picture, int most);

/// The picture of the open note, as a texture. Use it only on the OpenGL thread. Its destructor waits for a
/// file that is being read.
class NotePicture {
  public:
    /// Starts loading the file in the background, unless it was the last one loaded. There is no picture
    /// until loading is complete, or if the file is missing or cannot be read.
    void load(const std::filesystem::path& file);
    /// Uploads a loaded picture. To be called once per frame.
    void attend();
    bool loading() const { return read_.valid(); }
    /// 0: no picture.
    GLuint texture() const { return texture_.id(); }
    int width() const { return width_; }
    int height() const { return height_; }
    /// Error while reading; empty on success.
    const std::string& trouble() const { return trouble_; }

  private:
    struct Read {
        std::filesystem::path file;
        Picture picture;
        std::string trouble;
    };
    static Read read(const std::filesystem::path& file);
    void take(const Read& read);

    std::filesystem::path file_;
    std::future<Read> read_;
    std::string trouble_;
    gl::Texture texture_;
    int width_ = 0, height_ = 0;
};

}  // namespace vantage
