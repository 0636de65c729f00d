#include "pipeline/pixel_stages.h"

#include <algorithm>

#include "pipeline/import/photos.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/surface_samples.h"
#include "pipeline/stages/undistort.h"
#include "pipeline/trace.h"
#include "pipeline/write_tiles.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::Stage;
using package::Type;

RgbaImage decoded(const PhotoRun& run, PhotoFile& file) {
    if (auto image = run.s.ahead.take(run.at.i, file.identity())) return std::move(*image);
    const Traced traced(run.s.geometry.trace, "decode", run.photo.name);
    return decode_photo(run.photo.file, file.bytes(), run.photo.decoded);
}

/// Throws Error(input) where it is of another size.
RgbaImage read_stencil(const std::filesystem::path& file, const RgbaImage& photo) {
    try {
        return read_photo(file, {photo.width, photo.height});
    } catch (const Error& e) {
        throw Error(e.code(), "its stencil " + file.filename().string() + ": " + reason_of(e, file));
    }
}

/// Transparent where the stencil is black (below half) or transparent itself.
void cut_out(RgbaImage& image, const RgbaImage& stencil) {
    for (std::size_t p = 0; p < image.rgba.size(); p += 4)
        if (stencil.rgba[p] < 128 || stencil.rgba[p + 3] < 128) image.rgba[p + 3] = 0;
    image.opaque = false;
}

RgbaImage decode_pixels(const PhotoRun& run, PhotoFile& file, package::PhotoRecord& r) {
    RgbaImage image = decoded(run, file);
    if (!run.photo.stencil.empty()) cut_out(image, read_stencil(run.photo.stencil, image));
    const int longest = int(std::max(r.width, r.height));
    if (std::max(image.width, image.height) > longest)
        image = reduced(image, thumbnail_size(image.width, image.height, longest));
    if (!run.s.key.undistortion || !run.photo.camera.lens.distorts()) return image;
    r.flags |= package::photo_undistorted;
    const Traced traced(run.s.geometry.trace, "undistort", run.photo.name);
    return undistort(image, run.photo.camera, run.s.key.settings.resampling);
}

/// Thumbnail and tile pyramid.
void write_pixels(const PhotoStages& s, std::uint32_t i, const Due& due, RgbaImage level,
                  package::PhotoRecord& r, std::promise<CoarsePixels>& found) {
    const Traced traced(s.geometry.trace, "tiles", r.name);
    const bool opaque = is_opaque(level);
    if (!opaque) r.flags |= package::photo_has_alpha;
    CoarsePixels coarse;
    bool thumbnail_due = due[Stage::thumbnail];
    const std::uint32_t last = std::max(r.levels, std::uint32_t(sample_level) + 1);
    for (std::uint32_t l = 0; l < last; ++l) {
        if (l == std::uint32_t(mask_level) && !opaque) coarse.valid = validity(level);
        if (l == std::uint32_t(sample_level)) {
            coarse.samples = level;
            found.set_value(std::move(coarse));
        }
        if (l < r.levels && due[Stage::tiles])
            write_tiles(s.geometry.writer, Type::tiles, i, l, bytes_of(level.rgba),
                        {level.width, level.height});
        RgbaImage next = halve(level);
        // The coarsest level that still has the thumbnail's detail is the cheapest to reduce.
        const int wanted = int(std::max(r.thumbnail_width, r.thumbnail_height));
        if (thumbnail_due && (std::max(next.width, next.height) < wanted || l + 1 == last)) {
            const RgbaImage small = reduced(level, {int(r.thumbnail_width), int(r.thumbnail_height)});
            s.geometry.writer.write(Type::thumbnail, i, std::as_bytes(std::span(small.rgba)));
            thumbnail_due = false;
        }
        level = std::move(next);
    }
}

}  // namespace

void make_pixels(const PhotoRun& run, const Due& due, PhotoFile& file, package::PhotoRecord& r,
                 std::promise<CoarsePixels>& coarse) {
    RgbaImage image = decode_pixels(run, file, r);
    file.release();
    write_pixels(run.s, run.at.i, due, std::move(image), r, coarse);
}

}  // namespace vantage
