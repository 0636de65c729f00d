#include "pipeline/visibility/geometry_renderer.h"

#include "base/gl/context.h"
#include "base/text/error.h"
#include "pipeline/mesh/packed_model.h"
#include "pipeline/mesh/stand_in.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/trace.h"
#include "pipeline/visibility/border_distance.h"
#include "pipeline/visibility/gl_geometry.h"
#include "pipeline/visibility/gl_thread.h"
#include "pipeline/visibility/near_distance.h"
#include "pipeline/visibility/rasterize.h"
#include "pipeline/visibility/splat.h"

namespace vantage {

bool renders_by_opengl(const PrepareSettings& settings) {
    const bool floods = settings.distance == DistanceMethod::jump_flooding;
    if (settings.render_by == RenderBy::processor && floods)
        throw Error(Exit::usage,
                    std::string("--border-distance ") + name(settings.distance) +
                        ": jump flooding needs OpenGL and cannot be combined with --renderer cpu");
    return settings.render_by == RenderBy::opengl || floods ||
           (settings.render_by == RenderBy::automatic && gl::has_hardware());
}

/// The model is uploaded asynchronously; its buffers are created and destroyed on the OpenGL thread.
struct GeometryRenderer::OpenGl {
    GlThread thread;
    ModelBuffers buffers;
    std::shared_future<void> uploaded;

    ~OpenGl() {
        thread.submit([this] { buffers = {}; }).wait();
    }
    const ModelBuffers& model() {
        uploaded.get();
        return buffers;
    }
};

GeometryRenderer::GeometryRenderer(const PackedModel& model, const std::vector<Eigen::Vector3f>& normals,
                                   const PrepareSettings& settings)
    : model_(model), normals_(normals), distance_(settings.distance) {
    if (renders_by_opengl(settings)) gl_ = std::make_unique<OpenGl>();
    const bool hardware = gl_ && !gl_->thread.device().software;
    if (distance_ == DistanceMethod::automatic)
        distance_ = hardware ? DistanceMethod::jump_flooding : DistanceMethod::exact;
    if (!gl_) return;
    gl_->uploaded = gl_->thread
                        .submit([this] {
                            gl_->buffers = upload_model(model_.positions, normals_);
                            if (distance_ == DistanceMethod::jump_flooding)
                                gl_->buffers.jump_flood = jump_flood_program();
                        })
                        .share();
}

GeometryRenderer::~GeometryRenderer() = default;

bool GeometryRenderer::by_opengl() const { return gl_ != nullptr; }

void GeometryRenderer::splats(const SplatCloud& cloud) {
    cloud_ = &cloud;
    slack_ = facet_size(model_.positions, model_.indices);
}

std::future<PhotoGeometry> GeometryRenderer::render(std::shared_ptr<const PhotoView> view,
                                                    const Intrinsics& k, Trace* trace,
                                                    const std::string& photo) {
    auto rendered = render_model(view, k, trace, photo);
    if (!cloud_) return rendered;
    return std::async(std::launch::deferred, [=, this, rendered = std::move(rendered)]() mutable {
        PhotoGeometry maps = rendered.get();
        const Traced traced(trace, "splat", photo);
        splat(*cloud_, k, view->projection.cam_from_origin, slack_, maps);
        return maps;
    });
}

std::future<PhotoGeometry> GeometryRenderer::render_model(std::shared_ptr<const PhotoView> view,
                                                          const Intrinsics& k, Trace* trace,
                                                          const std::string& photo) {
    if (!gl_)
        return std::async(std::launch::deferred, [=, this] {
            const Traced traced(trace, "render", photo);
            return rasterize_geometry(view->projection, normals_, view->triangles.indices);
        });
    const ModelBuffers& buffers = gl_->model();
    return gl_->thread.submit([=, &buffers] {
        const Traced traced(trace, "render", photo);
        return render_geometry(buffers, view->triangles.indices, k, view->projection.cam_from_origin,
                               view->near_far);
    });
}

std::vector<float> GeometryRenderer::distances(const std::vector<std::uint8_t>& borders, int width,
                                               int height, int reach) {
    if (distance_ == DistanceMethod::exact)
        return reach <= max_near_distance ? near_distance(borders, width, height, reach)
                                          : exact_distance(borders, width, height);
    const ModelBuffers& buffers = gl_->model();
    return gl_->thread.submit([&] { return flood_distance(buffers.jump_flood, borders, width, height); })
        .get();
}

}  // namespace vantage
