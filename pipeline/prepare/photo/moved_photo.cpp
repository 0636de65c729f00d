#include "pipeline/prepare/photo/moved_photo.h"

#include <algorithm>

#include "base/values/bytes_of.h"
#include "base/values/halve.h"
#include "pipeline/output/earlier_package.h"
#include "pipeline/output/photo_records.h"
#include "pipeline/stages/surface_samples.h"
#include "pipeline/stages/tile_levels.h"
#include "scene/package/contents/pinhole_image.h"

namespace vantage {
namespace {

using package::PhotoRecord;
using package::PhotoState;
using package::Type;

RgbaImage tiles_at(const PackageReader& part, std::uint32_t photo, const PhotoRecord& r, int level) {
    const int stored = std::min(level, int(r.levels) - 1);
    RgbaImage image = read_level_image(part, r, photo, Type::tiles, stored);
    for (int l = stored; l < level; ++l) image = halve(image);
    return image;
}

}  // namespace

void move_photo(const GeometryContext& c, const PackageReader& part, std::uint32_t i, const Pose& pose,
                PhotoRecord& r, PhotoState& state) {
    const PosedPhoto photo{i, r.name, intrinsics(r), pose, lens_table(part, r, i)};
    set_pose(pose, r);
    const StageSet missing = stages_on_model();
    CoarsePixels coarse{{}, tiles_at(part, i, r, sample_level)};
    if (r.flags & package::photo_has_alpha) {
        const RgbaImage level = tiles_at(part, i, r, weight_map_level);
        coarse.valid = validity(photo.lens ? pinhole_image(level, *photo.lens, weight_map_level) : level);
    }
    std::promise<CoarsePixels> pixels;
    pixels.set_value(std::move(coarse));
    const auto view = std::make_shared<const PhotoView>(view_of(c, photo));
    StageInput in(c, photo, *view, c.renderer.render(view, photo.intrinsics, c.trace, photo.name).get(),
                  pixels.get_future(), r);
    make_on_model(in, missing);
    state.pose = pose_checksum(pose);
    state.transients = 0;
    for (const StageRow& row : stage_table())
        if (missing[row.stage])
            state.stages[std::size_t(row.stage)].content = content_of(row.stage, i, int(r.levels), c.writer);
    seal(state, r);
    c.writer.note(Type::photos, i, bytes_of_one(r));
    c.writer.note(Type::states, i, bytes_of_one(state));
}

}  // namespace vantage
