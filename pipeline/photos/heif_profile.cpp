#include "pipeline/photos/heif_profile.h"

#include <libheif/heif.h>

#include <memory>

namespace vantage {

std::vector<std::byte> heif_profile(const std::filesystem::path& file) {
    const std::unique_ptr<heif_context, decltype(&heif_context_free)> context(heif_context_alloc(),
                                                                              heif_context_free);
    heif_image_handle* found = nullptr;
    if (heif_context_read_from_file(context.get(), file.c_str(), nullptr).code != heif_error_Ok ||
        heif_context_get_primary_image_handle(context.get(), &found).code != heif_error_Ok)
        return {};
    const std::unique_ptr<heif_image_handle, decltype(&heif_image_handle_release)> image(
        found, heif_image_handle_release);
    std::vector<std::byte> icc(heif_image_handle_get_raw_color_profile_size(image.get()));
    if (heif_image_handle_get_raw_color_profile(image.get(), icc.data()).code != heif_error_Ok) return {};
    return icc;
}

}  // namespace vantage
