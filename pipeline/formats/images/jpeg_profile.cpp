#include "pipeline/formats/images/jpeg_profile.h"

#include <cstdlib>
#include <memory>

#include "codec/jpeg_failure.h"

namespace vantage {
namespace {

struct Found {
    bool any = false;
    JOCTET* bytes = nullptr;  ///< to be freed
    unsigned size = 0;
};

/// Has no destructors to run, because errors jump out of it.
void find_profile(std::span<const std::byte> jpeg, Found& found) {
    jpeg_decompress_struct info{};
    codec::JpegFailure failure{};
    info.err = codec::jumping_errors(failure);
    if (setjmp(failure.jump) == 0) {
        jpeg_create_decompress(&info);
        jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size());
        jpeg_save_markers(&info, JPEG_APP0 + 2, 0xffff);
        jpeg_read_header(&info, TRUE);
        const long warnings = failure.errors.num_warnings;
        found.any = jpeg_read_icc_profile(&info, &found.bytes, &found.size) ||
                    failure.errors.num_warnings > warnings;  // segments are missing
    }
    jpeg_destroy_decompress(&info);
}

}  // namespace

std::optional<std::vector<std::byte>> jpeg_profile(std::span<const std::byte> jpeg) {
    Found found;
    find_profile(jpeg, found);
    const std::unique_ptr<JOCTET, decltype(&std::free)> owned(found.bytes, std::free);
    if (!found.any) return {};
    const auto* first = reinterpret_cast<const std::byte*>(found.bytes);
    return std::vector<std::byte>(first, first + found.size);
}

}  // namespace vantage
