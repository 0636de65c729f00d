#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "base/values/bytes_of.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Appends values and their number, to pass them to another process of this program.
template <class T>
void append(std::vector<std::byte>& out, const std::vector<T>& values) {
    const std::uint64_t bytes = values.size() * sizeof(T);
    for (const auto part : {bytes_of_one(bytes), bytes_of(values)})
        out.insert(out.end(), part.begin(), part.end());
}

/// Removes values appended by append() from the front.
template <class T>
void take(std::span<const std::byte>& from, std::vector<T>& values) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, from.data(), sizeof bytes);
    values.resize(bytes / sizeof(T));
    std::ranges::copy(from.subspan(sizeof bytes, bytes), reinterpret_cast<std::byte*>(values.data()));
    from = from.subspan(sizeof bytes + bytes);
}

/// Like append() and take() above, for a mesh without its scalar fields.
inline void append(std::vector<std::byte>& out, const Mesh& mesh) {
    append(out, mesh.positions);
    append(out, mesh.normals);
    append(out, mesh.colors);
    append(out, mesh.triangles);
}
inline void take(std::span<const std::byte>& from, Mesh& mesh) {
    take(from, mesh.positions);
    take(from, mesh.normals);
    take(from, mesh.colors);
    take(from, mesh.triangles);
}

}  // namespace vantage
