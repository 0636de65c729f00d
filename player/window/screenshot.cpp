#include "player/window/screenshot.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "player/render/picture.h"

namespace vantage {

void save_frame(const std::string& file, int width, int height) {
    Picture p{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4), {}};
    std::vector<std::uint8_t> rows(p.rgba.size());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    const auto stride = std::ptrdiff_t(width) * 4;
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.begin() + (height - 1 - y) * stride, stride, p.rgba.begin() + y * stride);
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) p.rgba[i] = 255;
    write_png(file, p);
}

}  // namespace vantage
