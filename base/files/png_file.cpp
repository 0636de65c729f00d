#include "base/files/png_file.h"

#include "base/files/png_rows.h"

namespace vantage {

void write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba) {
    PngRows out(file, width, height);
    for (std::size_t row = 4 * std::size_t(width); !rgba.empty(); rgba = rgba.subspan(row))
        out.add(rgba.first(row));
    out.finish();
}

}  // namespace vantage
