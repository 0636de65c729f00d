#include "pipeline/photos/jpeg_photo.h"

#include <cstdlib>
#include <memory>

#include "codec/jpeg_failure.h"

namespace vantage {
namespace {

struct Found {
    char flaw[JMSG_LENGTH_MAX] = "";
    int width = 0, height = 0;
    J_COLOR_SPACE space = JCS_UNKNOWN;
    bool any_profile = false;
    JOCTET* profile = nullptr;  ///< to be freed
    unsigned profile_size = 0;
};

/// Has no destructors to run, because errors jump out of it.
void find(std::span<const std::byte> jpeg, Found& found) {
    jpeg_decompress_struct info{};
    codec::JpegFailure failure{};
    info.err = codec::jumping_errors(failure);
    if (setjmp(failure.jump) == 0) {
        jpeg_create_decompress(&info);
        jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
        jpeg_save_markers(&info, JPEG_APP0 + 2, 0xffff);
        jpeg_read_header(&info, TRUE);
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
    JpegPhoto out{found.flaw, found.width, found.height, colors_of(found.space), {}};
    const auto* first = reinterpret_cast<const std::byte*>(found.profile);
    if (found.any_profile) out.profile.emplace(first, first + found.profile_size);
    return out;
}

}  // namespace vantage
