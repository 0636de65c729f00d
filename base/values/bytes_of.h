#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace vantage {

/// The bytes of a vector's elements.
template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& v) {
    return std::as_bytes(std::span<const T>(v));
}

/// The bytes of a single value.
template <class T>
std::span<const std::byte> bytes_of_one(const T& value) {
    return std::as_bytes(std::span<const T>(&value, 1));
}

}  // namespace vantage
