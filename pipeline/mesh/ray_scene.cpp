#include "pipeline/mesh/ray_scene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstring>
#include <limits>
#include <stdexcept>

#include "base/text/error.h"

namespace vantage {
namespace {

RTCRay ray_of(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double nearest,
              double farthest) {
    RTCRay ray{};
    ray.org_x = float(origin.x()), ray.org_y = float(origin.y()), ray.org_z = float(origin.z());
    ray.dir_x = float(direction.x()), ray.dir_y = float(direction.y()), ray.dir_z = float(direction.z());
    ray.tnear = float(nearest);
    ray.tfar = float(farthest);
    ray.mask = ~0u;
    return ray;
}

// Embree 3 requires a context; Embree 4 does not.
#if RTC_VERSION_MAJOR >= 4
void intersect(RTCScene scene, RTCRayHit& hit) { rtcIntersect1(scene, &hit); }
void occlude(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray); }
#else
void intersect(RTCScene scene, RTCRayHit& hit) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &hit);
}
void occlude(RTCScene scene, RTCRay& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
}
#endif

}  // namespace

struct RayScene::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    ~State() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

namespace {

std::vector<Eigen::Vector3f> rounded(std::span<const Eigen::Vector3d> positions) {
    std::vector<Eigen::Vector3f> out;
    for (const Eigen::Vector3d& p : positions) out.push_back(p.cast<float>());
    return out;
}

std::span<const std::uint32_t> flat(std::span<const std::array<std::uint32_t, 3>> triangles) {
    return {triangles.empty() ? nullptr : triangles.front().data(), triangles.size() * 3};
}

}  // namespace

RayScene::RayScene(const Mesh& mesh) : RayScene(rounded(mesh.positions), flat(mesh.triangles)) {}

RayScene::RayScene(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices)
    : state_(std::make_unique<State>()) {
    state_->device = rtcNewDevice(nullptr);
    if (!state_->device) throw std::runtime_error("Embree cannot create a device");
    state_->scene = rtcNewScene(state_->device);
    rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex_buffer = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, positions.size()));
    auto* index_buffer = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, indices.size() / 3));
    if (!vertex_buffer || !index_buffer) {
        rtcReleaseGeometry(geometry);
        throw Error(Exit::memory, "not enough memory for Embree to hold the mesh");
    }
    std::memcpy(vertex_buffer, positions.data(), positions.size_bytes());
    std::memcpy(index_buffer, indices.data(), indices.size_bytes());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(state_->scene);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;

std::optional<RayHit> RayScene::first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                          double nearest) const {
    RTCRayHit hit{};
    hit.ray = ray_of(origin, direction, nearest, std::numeric_limits<float>::infinity());
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(state_->scene, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{hit.hit.primID, double(hit.ray.tfar), {double(hit.hit.u), double(hit.hit.v)}};
}

bool RayScene::occluded(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double nearest,
                        double farthest) const {
    RTCRay ray = ray_of(origin, direction, nearest, farthest);
    occlude(state_->scene, ray);
    return ray.tfar < 0;
}

}  // namespace vantage
