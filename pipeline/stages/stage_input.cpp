#include "pipeline/stages/stage_input.h"

#include <utility>

#include "pipeline/stages/coordinates/facet_coordinates.h"
#include "pipeline/stages/coordinates/vertex_coordinates.h"

namespace vantage {

std::vector<std::uint8_t> validity(const RgbaImage& level) {
    std::vector<std::uint8_t> valid(level.rgba.size() / 4);
    for (std::size_t p = 0; p < valid.size(); ++p) valid[p] = level.rgba[4 * p + 3] == 255;
    return valid;
}

PhotoView view_of(const GeometryContext& c, const PosedPhoto& photo) {
    const Traced traced(c.trace, "project", photo.name);
    const Eigen::Vector2d near_far =
        depth_range(c.model.opaque_positions(), photo.pose, model_reach(c.model.record, photo.pose));
    return {triangles_in_frame(c.model.opaque_clusters(), c.model.indices, photo.intrinsics, photo.pose),
            near_far,
            project_model(c.model.opaque_positions(), map_intrinsics(photo.intrinsics), photo.pose,
                          near_far.x())};
}

StageInput::StageInput(const GeometryContext& context, const PosedPhoto& photo, const PhotoView& view,
                       PhotoGeometry geometry, std::future<CoarsePixels> pixels, package::PhotoRecord& record)
    : context(context),
      photo(photo),
      view(view),
      geometry(std::move(geometry)),
      record(record),
      awaited_(std::move(pixels)) {}

const std::vector<Eigen::Vector2f>& StageInput::coordinates() {
    if (coordinates_) return *coordinates_;
    const Traced traced(context.trace, "coordinates", photo.name);
    const PackedModel& model = context.model;
    if (context.renderer.cloud())
        return coordinates_.emplace(
            facet_coordinates(view.projection, model.indices, geometry, photo.intrinsics));
    coordinates_ = vertex_coordinates(view.projection, view.triangles.indices, photo.intrinsics);
    coordinates_->resize(model.positions.size(), Eigen::Vector2f(-1, -1));  // photos see through the others
    return *coordinates_;
}

CoarsePixels& StageInput::pixels() {
    if (!pixels_) pixels_ = awaited_.get();
    return *pixels_;
}

}  // namespace vantage
