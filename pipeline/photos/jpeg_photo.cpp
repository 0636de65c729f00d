#include "pipeline/photos/jpeg_photo.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "scene/codec/jpeg_failure.h"

namespace vantage {
namespace {

struct Found {
    char flaw[JMSG_LENGTH_MAX] = "";
    int width = 0, height = 0;
    int orientation = 1;
    J_COLOR_SPACE space = JCS_UNKNOWN;
    bool any_profile = false;
    JOCTET* profile = nullptr;  ///< to be freed
    unsigned profile_size = 0;
};

/// The orientation in an APP1 segment (Exif 2.3, 4.5.4 and 4.6.2); 1 if there is none.
int orientation_of(std::span<const std::uint8_t> app1) {
    constexpr std::string_view exif("Exif\0\0", 6);
    if (app1.size() < exif.size() + 8 || !std::equal(exif.begin(), exif.end(), app1.begin())) return 1;
    const auto tiff = app1.subspan(exif.size());
    const bool big = tiff[0] == 'M';
    const auto number = [&](std::size_t at, std::size_t bytes) {
        std::size_t out = 0;
        for (std::size_t i = 0; i < bytes && at + bytes <= tiff.size(); ++i)
            out |= std::size_t(tiff[at + (big ? bytes - 1 - i : i)]) << (8 * i);
        return out;
    };
    const std::size_t folder = number(4, 4), entries = number(folder, 2);
    constexpr std::size_t orientation = 0x112, entry = 12;
    for (std::size_t at = folder + 2; at < folder + 2 + entry * entries && at + entry <= tiff.size();
         at += entry)
        if (number(at, 2) == orientation) {
            constexpr std::size_t type_long = 4;
            const auto value = int(number(at + 8, number(at + 2, 2) == type_long ? 4 : 2));
            return value >= 1 && value <= 8 ? value : 1;
        }
    return 1;
}

/// This function must not have any objects with destructors, because errors leave it by longjmp.
void find(std::span<const std::byte> jpeg, Found& found) {
    jpeg_decompress_struct info{};
    codec::JpegFailure failure{};
    info.err = codec::jumping_errors(failure);
    if (setjmp(failure.jump) == 0) {
        jpeg_create_decompress(&info);
        jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
        jpeg_save_markers(&info, JPEG_APP0 + 1, 0xffff);
        jpeg_save_markers(&info, JPEG_APP0 + 2, 0xffff);
        jpeg_read_header(&info, TRUE);
        for (const auto* m = info.marker_list; m && found.orientation == 1; m = m->next)
            if (m->marker == JPEG_APP0 + 1) found.orientation = orientation_of({m->data, m->data_length});
        found.width = int(info.image_width);
        found.height = int(info.image_height);
        found.space = info.jpeg_color_space;
        const long warnings = failure.errors.num_warnings;
        found.any_profile = jpeg_read_icc_profile(&info, &found.profile, &found.profile_size) ||
                            failure.errors.num_warnings > warnings;  // segments are missing
    } else {
        failure.errors.format_message(reinterpret_cast<j_common_ptr>(&info), found.flaw);
    }
    jpeg_destroy_decompress(&info);
}

PixelColors colors_of(J_COLOR_SPACE space) {
    if (space == JCS_GRAYSCALE) return PixelColors::gray;
    return space == JCS_CMYK || space == JCS_YCCK ? PixelColors::cmyk : PixelColors::rgb;
}

}  // namespace

JpegPhoto read_jpeg_photo(std::span<const std::byte> jpeg) {
    Found found;
    find(jpeg, found);
    const std::unique_ptr<JOCTET, decltype(&std::free)> owned(found.profile, std::free);
    JpegPhoto out{found.flaw, found.width, found.height, found.orientation, colors_of(found.space), {}};
    const auto* first = reinterpret_cast<const std::byte*>(found.profile);
    if (found.any_profile) out.profile.emplace(first, first + found.profile_size);
    return out;
}

}  // namespace vantage
