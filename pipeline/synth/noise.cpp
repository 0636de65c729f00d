#include "pipeline/synth/noise.h"

#include <algorithm>
#include <cmath>

namespace vantage {

using Eigen::Vector3d;

double hashed(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t h = std::uint64_t(x) * 0x9E3779B97F4A7C15ull ^ std::uint64_t(y) * 0xC2B2AE3D27D4EB4Full ^
                      std::uint64_t(z) * 0x165667B19E3779F9ull;
    h ^= h >> 29;
    h *= 0xBF58476D1CE4E5B9ull;
    h ^= h >> 32;
    return double(h >> 11) * 0x1p-53;
}

double noise(const Vector3d& p) {
    const Vector3d f = p.array().floor(), t = p - f;
    const Vector3d s = t.array() * t.array() * (3 - 2 * t.array());
    const auto corner = [&](int i, int j, int k) {
        return hashed(std::int64_t(f.x()) + i, std::int64_t(f.y()) + j, std::int64_t(f.z()) + k);
    };
    double sum = 0;
    for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        sum += (i ? s.x() : 1 - s.x()) * (j ? s.y() : 1 - s.y()) * (k ? s.z() : 1 - s.z()) * corner(i, j, k);
    }
    return sum;
}

double turbulence(const Vector3d& p, double frequency, int octaves) {
    double sum = 0, weight = 0.5;
    for (int o = 0; o < octaves; ++o, frequency *= 2.1, weight *= 0.55) sum += weight * noise(p * frequency);
    return std::min(1.0, sum);
}

namespace {

/// Like noise(), but in [-1, 1] and in single precision, for callers that need many octaves.
float quick_noise(float x, float y, float z) {
    const auto floored = [](float v) { return float(std::int32_t(v) - (float(std::int32_t(v)) > v)); };
    const float fx = floored(x), fy = floored(y), fz = floored(z);
    const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
    const float sx = smooth(x - fx), sy = smooth(y - fy), sz = smooth(z - fz);
    const std::uint32_t hx = std::uint32_t(std::int32_t(fx)) * 0x9E3779B1u,
                        hy = std::uint32_t(std::int32_t(fy)) * 0x85EBCA77u,
                        hz = std::uint32_t(std::int32_t(fz)) * 0xC2B2AE3Du;
    const auto corner = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        std::uint32_t h = (hx + i * 0x9E3779B1u) ^ (hy + j * 0x85EBCA77u) ^ (hz + k * 0xC2B2AE3Du);
        h = (h ^ h >> 15) * 0x2C1B3C6Du;
        return float(std::int32_t(h)) * 0x1p-31f;
    };
    const auto along = [&](std::uint32_t j, std::uint32_t k) {
        return corner(0, j, k) + sx * (corner(1, j, k) - corner(0, j, k));
    };
    const float low = along(0, 0) + sy * (along(1, 0) - along(0, 0)),
                high = along(0, 1) + sy * (along(1, 1) - along(0, 1));
    return low + sz * (high - low);
}

}  // namespace

double rough(const Vector3d& p, double coarsest, double footprint, double fall) {
    double sum = 0, weight = 1;
    Eigen::Vector3f q = (p / coarsest).cast<float>();
    for (double wave = coarsest; wave > 2 * footprint; wave /= 2, weight *= fall) {
        sum += weight * std::min(1.0, wave / footprint - 2) * double(quick_noise(q.x(), q.y(), q.z()));
        // rotated by 37 degrees about z and shifted, which hides the lattice
        q = Eigen::Vector3f(1.597f * q.x() - 1.204f * q.y() + 17.3f, 1.204f * q.x() + 1.597f * q.y() + 5.1f,
                            2.0f * q.z() + 9.7f);
    }
    return sum;
}

}  // namespace vantage
