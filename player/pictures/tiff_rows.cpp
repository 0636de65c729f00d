#include "player/pictures/tiff_rows.h"

#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace vantage {
namespace {

constexpr std::uint32_t pixel_scale_tag = 33550, tie_point_tag = 33922, geo_keys_tag = 34735;
constexpr std::int64_t max_classic_bytes = std::int64_t(3) << 30;  // uncompressed
constexpr std::int64_t strip_bytes = std::int64_t(1) << 20;

void add_geo_tags(TIFF* tiff) {
    static char scale[] = "ModelPixelScaleTag", tie[] = "ModelTiepointTag", keys[] = "GeoKeyDirectoryTag";
    static const TIFFFieldInfo fields[] = {{pixel_scale_tag, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, scale},
                                           {tie_point_tag, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, tie},
                                           {geo_keys_tag, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, keys}};
    TIFFMergeFieldInfo(tiff, fields, std::size(fields));
}

template <class Value, std::size_t count>
bool set_values(TIFF* tiff, std::uint32_t tag, const std::array<Value, count>& values) {
    return TIFFSetField(tiff, tag, int(count), values.data()) == 1;
}

/// Writes the georeference: the corner of the first pixel is at `upper_left`, without a geographic coordinate
/// system.
bool set_place(TIFF* tiff, const Eigen::Vector2d& upper_left, double resolution) {
    constexpr std::uint16_t model_type = 1024, raster_type = 1025, user_defined = 32767, pixel_is_area = 1;
    constexpr std::array<std::uint16_t, 12> keys{1,           1, 0, 2,             // version 1.1.0, two keys
                                                 model_type,  0, 1, user_defined,  //
                                                 raster_type, 0, 1, pixel_is_area};
    add_geo_tags(tiff);
    return set_values(tiff, pixel_scale_tag, std::array{resolution, resolution, 0.0}) &&
           set_values(tiff, tie_point_tag, std::array{0.0, 0.0, 0.0, upper_left.x(), upper_left.y(), 0.0}) &&
           set_values(tiff, geo_keys_tag, keys);
}

bool set_pixels(TIFF* tiff, int width, int height) {
    const std::int64_t row = 4 * std::int64_t(width);
    const auto rows = std::uint32_t(std::clamp<std::int64_t>(strip_bytes / row, 1, height));
    constexpr std::array<std::uint16_t, 1> alpha{EXTRASAMPLE_UNASSALPHA};
    return TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, std::uint32_t(width)) &&
           TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, std::uint32_t(height)) &&
           TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 4) && TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8) &&
           TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB) &&
           TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, alpha.data()) &&
           TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) &&
           TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE) &&
           TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL) &&
           TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rows);
}

}  // namespace

TiffRows::TiffRows(const std::filesystem::path& file, int width, int height,
                   const Eigen::Vector2d& upper_left, double resolution)
    : file_(file), tiff_(nullptr, TIFFClose) {
    TIFFSetErrorHandler(nullptr);  // errors are reported by exceptions instead
    TIFFSetWarningHandler(nullptr);
    const bool large = 4 * std::int64_t(width) * height > max_classic_bytes;
    errno = 0;
    tiff_.reset(TIFFOpen(file_.part().c_str(), large ? "w8" : "w"));
    if (!tiff_ || !set_pixels(tiff_.get(), width, height) || !set_place(tiff_.get(), upper_left, resolution))
        fail();
}

void TiffRows::fail() const { file_.fail(errno ? std::strerror(errno) : ""); }

void TiffRows::add(std::span<const std::uint8_t> row) {
    pixels_.assign(row.begin(), row.end());
    errno = 0;
    if (TIFFWriteScanline(tiff_.get(), pixels_.data(), row_++) != 1) fail();
}

void TiffRows::finish() {
    errno = 0;
    // TIFFClose() does not report write errors.
    if (TIFFWriteDirectory(tiff_.get()) != 1 || ::fsync(TIFFFileno(tiff_.get())) != 0) fail();
    tiff_.reset();
    file_.finish();
}

}  // namespace vantage
