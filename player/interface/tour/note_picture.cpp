#include "player/interface/tour/note_picture.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text/error.h"
#include "scene/codec/jpeg_pixels.h"

namespace vantage {
namespace {

constexpr std::uint64_t max_bytes = std::uint64_t(64) << 20, max_pixels = 40'000'000;
constexpr int max_side = 1600;  ///< of the texture

struct Size {
    int width, height;
};

int two_bytes(std::span<const std::byte> b, std::size_t at) {
    return std::to_integer<int>(b[at]) << 8 | std::to_integer<int>(b[at + 1]);
}

/// The size given in the header of a PNG.
std::optional<Size> png_size(std::span<const std::byte> b) {
    if (b.size() < 24 || std::to_integer<int>(b[0]) != 0x89 || std::to_integer<int>(b[1]) != 'P') return {};
    if (two_bytes(b, 16) != 0 || two_bytes(b, 20) != 0) return Size{1 << 16, 1 << 16};  // or larger
    return Size{two_bytes(b, 18), two_bytes(b, 22)};
}

/// The size given in the frame header of a JPEG (ITU-T T.81, B.2.2).
std::optional<Size> jpeg_size(std::span<const std::byte> b) {
    if (b.size() < 4 || two_bytes(b, 0) != 0xffd8) return {};
    for (std::size_t at = 2; at + 9 <= b.size();) {
        const int marker = two_bytes(b, at);
        if (marker >> 8 != 0xff) return {};
        if (marker == 0xffff) {  // a byte of padding
            ++at;
            continue;
        }
        const bool frame = marker >= 0xffc0 && marker <= 0xffcf && marker % 4 != 0;
        if (frame || marker == 0xffc0) return Size{two_bytes(b, at + 7), two_bytes(b, at + 5)};
        at += 2 + std::size_t(two_bytes(b, at + 2));
    }
    return {};
}

std::vector<std::byte> bytes_of(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw Error(Exit::input, file.string() + ": does not exist");
    if (std::filesystem::file_size(file, error) > max_bytes)
        throw Error(Exit::input, file.string() + ": is longer than 64 MiB, expected a smaller picture");
    std::ifstream in(file, std::ios::binary);
    std::vector<std::byte> out(std::filesystem::file_size(file, error));
    in.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size()));
    if (in.gcount() != std::streamsize(out.size()))
        throw Error(Exit::input, file.string() + ": cannot be read");
    return out;
}

}  // namespace

Picture read_note_picture(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = bytes_of(file);
    const auto png = png_size(bytes), jpeg = jpeg_size(bytes);
    if (!png && !jpeg) throw Error(Exit::input, file.string() + ": is not a PNG or JPEG file");
    const Size size = png ? *png : *jpeg;
    if (size.width < 1 || size.height < 1 ||
        std::uint64_t(size.width) * std::uint64_t(size.height) > max_pixels)
        throw Error(Exit::input,
                    file.string() + ": has no size or more than 40 megapixels, expected a smaller picture");
    if (png) return read_png(file);
    Picture out{size.width, size.height, {}, {}};
    out.rgba.resize(4 * std::size_t(size.width) * std::size_t(size.height));
    if (!codec::decode_jpeg(bytes, size.width, size.height, std::as_writable_bytes(std::span(out.rgba))))
        throw Error(Exit::input, file.string() + ": is damaged, or not a color or grayscale JPEG");
    return out;
}

Picture reduced_picture(Picture p, int most) {
    const int by = (std::max(p.width, p.height) + most - 1) / most;
    if (by <= 1) return p;
    Picture out{p.width / by, p.height / by, {}, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                int sum = 0;
                for (int dy = 0; dy < by; ++dy)
                    for (int dx = 0; dx < by; ++dx)
                        sum += p.rgba[4 * (std::size_t(y * by + dy) * std::size_t(p.width) +
                                           std::size_t(x * by + dx)) +
                                      c];
                out.rgba.push_back(std::uint8_t(sum / (by * by)));
            }
    return out;
}

NotePicture::Read NotePicture::read(const std::filesystem::path& file) {
    try {
        return {file, reduced_picture(read_note_picture(file), max_side), {}};
    } catch (const Error& e) {
        return {file, {}, e.what()};
    }
}

void NotePicture::load(const std::filesystem::path& file) {
    if (file != file_) {
        file_ = file;
        trouble_.clear();
        texture_ = {};
    }
    if (!file_.empty() && !texture_ && trouble_.empty() && !read_.valid())
        read_ = std::async(std::launch::async, [file] { return read(file); });
}

void NotePicture::attend() {
    if (!read_.valid() || read_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    if (const Read read = read_.get(); read.file == file_) take(read);
}

void NotePicture::take(const Read& read) {
    const Picture& p = read.picture;
    trouble_ = read.trouble;
    if (!trouble_.empty()) return;
    if (p.width < 1 || p.height < 1) {
        trouble_ = read.file.string() + ": is too narrow";
        return;
    }
    texture_ = gl::make_texture_2d("picture of a note", GL_RGBA8, p.width, p.height, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture_.id(), 0, 0, 0, p.width, p.height, GL_RGBA, GL_UNSIGNED_BYTE, p.rgba.data());
    width_ = p.width, height_ = p.height;
}

}  // namespace vantage
