#include "tests/openxr/pose.h"

#include <cmath>

namespace test_runtime {
namespace {

XrQuaternionf product(const XrQuaternionf& a, const XrQuaternionf& b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

XrQuaternionf conjugate(const XrQuaternionf& q) { return {-q.x, -q.y, -q.z, q.w}; }

}  // namespace

XrVector3f rotated(const XrQuaternionf& q, const XrVector3f& v) {
    const XrQuaternionf out = product(product(q, {v.x, v.y, v.z, 0}), conjugate(q));
    return {out.x, out.y, out.z};
}

XrPosef composed(const XrPosef& outer, const XrPosef& inner) {
    const XrVector3f moved = rotated(outer.orientation, inner.position);
    const XrVector3f& at = outer.position;
    return {product(outer.orientation, inner.orientation), {at.x + moved.x, at.y + moved.y, at.z + moved.z}};
}

XrPosef inverse(const XrPosef& pose) {
    const XrQuaternionf back = conjugate(pose.orientation);
    const XrVector3f moved = rotated(back, pose.position);
    return {back, {-moved.x, -moved.y, -moved.z}};
}

XrPosef levelled(const XrPosef& pose) {
    const XrVector3f ahead = rotated(pose.orientation, {0, 0, -1});
    const float half = std::atan2(-ahead.x, -ahead.z) / 2;
    return {{0, std::sin(half), 0, std::cos(half)}, pose.position};
}

bool is_valid(const XrPosef& pose) {
    const auto& [q, p] = pose;
    const float length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return std::abs(length - 1) <= .01f && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace test_runtime
