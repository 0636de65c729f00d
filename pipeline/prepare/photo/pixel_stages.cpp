#include "pipeline/prepare/photo/pixel_stages.h"

#include <algorithm>

#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "base/values/halve.h"
#include "pipeline/photos/photos.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/stages/surface_samples.h"
#include "pipeline/stages/tile_levels.h"
#include "scene/package/contents/pinhole_image.h"

namespace vantage {
namespace {

RgbaImage decoded(const PhotoJob& job, PhotoFile& file) {
    if (auto image = job.context.prefetch.take(job.at.index, file.identity())) return std::move(*image);
    const Traced traced(job.context.trace, "decode", job.photo.name);
    return decode_photo(job.photo.file, file.bytes(), job.photo.decoded);
}

/// Throws Error(input) if the mask and the photo differ in size.
RgbaImage read_mask(const std::filesystem::path& file, const RgbaImage& photo) {
    try {
        return read_unprofiled(file, {photo.width, photo.height});
    } catch (const Error& e) {
        throw Error(e.code(), "its mask " + file.filename().string() + ": " + reason_of(e, file));
    }
}

/// Makes the photo transparent where the mask is dark (below 128) or transparent.
void cut_out(RgbaImage& image, const RgbaImage& mask) {
    for (std::size_t p = 0; p < image.rgba.size(); p += 4)
        if (mask.rgba[p] < 128 || mask.rgba[p + 3] < 128) image.rgba[p + 3] = 0;
    image.opaque = false;
}

/// A photo's pixels; `own`: the pixels are unchanged from the file.
struct Pixels {
    RgbaImage image;
    bool own;
};

Pixels decode_pixels(const PhotoJob& job, PhotoFile& file, const package::PhotoRecord& r) {
    RgbaImage image = decoded(job, file);
    const bool whole = job.photo.mask.empty();
    if (!whole) cut_out(image, read_mask(job.photo.mask, image));
    const bool full_size = image.width == int(r.width) && image.height == int(r.height);
    const bool own = whole && full_size && !job.photo.profile.converts;
    const int longest = int(std::max(r.width, r.height));
    if (std::max(image.width, image.height) > longest)
        image = reduced(image, thumbnail_size(image.width, image.height, longest));
    return {std::move(image), own};
}

/// The valid texels of a photo that is not opaque, at `weight_map_level`.
std::vector<std::uint8_t> valid_texels(const PhotoJob& job, const RgbaImage& level) {
    if (!job.at.lens) return validity(level);
    const Traced traced(job.context.trace, "lens", job.photo.name);
    return validity(pinhole_image(level, *job.at.lens, weight_map_level));
}

/// Runs the stages that do not use the model. `jpeg`: the photo's file if level 0 can be taken from it,
/// otherwise empty.
void write_pixels(const PhotoJob& job, const StageSet& missing, RgbaImage level,
                  std::span<const std::byte> jpeg, package::PhotoRecord& r,
                  std::promise<CoarsePixels>& found) {
    const Traced traced(job.context.trace, "tiles", r.name);
    PackageWriter& writer = job.context.writer;
    const std::uint32_t i = job.at.index;
    const bool opaque = is_opaque(level);
    if (!opaque) r.flags |= package::photo_has_alpha;
    CoarsePixels coarse;
    // Samples are taken from the stored pixels, so that recomputing them later gives the same values.
    const std::uint32_t sampled = std::min(std::uint32_t(sample_level), r.levels - 1);
    const std::uint32_t last = std::max(r.levels, std::uint32_t(sample_level) + 1);
    for (std::uint32_t l = 0; l < last; ++l) {
        if (l == std::uint32_t(weight_map_level) && !opaque) coarse.valid = valid_texels(job, level);
        const bool own = l == 0 && !jpeg.empty();
        if (l == sampled)
            coarse.samples = own ? level : as_stored(writer, i, l, level, level_quality(jpeg, l));
        if (l > sampled && l <= std::uint32_t(sample_level)) coarse.samples = halve(coarse.samples);
        if (l == std::uint32_t(sample_level)) found.set_value(std::move(coarse));
        LevelInput in{writer, i, r, l, l + 1 == last, level, jpeg};
        make_on_level(in, missing);
        if (l + 1 < last) level = halve(level);
    }
}

}  // namespace

void make_pixels(const PhotoJob& job, const StageSet& missing, PhotoFile& file, package::PhotoRecord& r,
                 std::promise<CoarsePixels>& coarse) {
    Pixels pixels = decode_pixels(job, file, r);
    const bool kept =
        job.context.key.compact && pixels.own && is_upright_jpeg(file.bytes(), {int(r.width), int(r.height)});
    if (!kept) file.release();
    const auto jpeg = kept ? file.bytes() : std::span<const std::byte>{};
    write_pixels(job, missing, std::move(pixels.image), jpeg, r, coarse);
    file.release();
}

}  // namespace vantage
