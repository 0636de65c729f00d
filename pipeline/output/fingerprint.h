#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "base/files/checksum.h"
#include "base/values/bytes_of.h"
#include "scene/camera/camera.h"

namespace vantage {

/// The XXH3-64 hash of the bytes of successive values. Accepts only types without padding.
class Fingerprint {
  public:
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Fingerprint& add(const T& value) {
        const auto bytes = bytes_of_one(value);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        return *this;
    }
    template <class Derived>
    Fingerprint& add(const Eigen::MatrixBase<Derived>& m) {
        for (int r = 0; r < m.rows(); ++r)
            for (int c = 0; c < m.cols(); ++c) add(double(m(r, c)));
        return *this;
    }
    Fingerprint& add(const Intrinsics& k) {
        return add(k.width).add(k.height).add(k.fx).add(k.fy).add(k.cx).add(k.cy);
    }
    Fingerprint& add(const Lens& lens) {
        add(lens.model);
        const std::size_t used = lens.model == LensModel::aria ? lens.p.size() : 8;  // others: at most 8
        for (std::size_t i = 0; i < used; ++i) add(lens.p[i]);
        return *this;
    }
    std::uint64_t value() const { return checksum(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

}  // namespace vantage
