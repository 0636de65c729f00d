#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace vantage {

/// Hash of integer coordinates, in [0, 1).
double hashed(std::int64_t x, std::int64_t y, std::int64_t z);

/// Value noise in [0, 1] on the unit lattice.
double noise(const Eigen::Vector3d& p);

/// Sum of octaves of noise, in [0, 1]; the coarsest octave has the frequency `frequency` per meter.
double turbulence(const Eigen::Vector3d& p, double frequency, int octaves);

/// Fractal noise around 0, mostly within [-1, 1]: octaves with wavelengths from `coarsest` down to twice the
/// `footprint` of a pixel, both in meters. Each octave has `fall` times the amplitude of the next coarser
/// one. Detail finer than a pixel is omitted to avoid aliasing.
double rough(const Eigen::Vector3d& p, double coarsest, double footprint, double fall);

inline Eigen::Vector3f mix(const Eigen::Vector3f& a, const Eigen::Vector3f& b, double t) {
    return a + (b - a) * float(t);
}

}  // namespace vantage
