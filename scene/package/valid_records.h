#pragma once
#include <cstring>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// A copy of the records of a chunk without blocks; empty if the chunk is missing or damaged.
template <class T>
std::vector<T> valid_records(const PackageReader& package, package::Type type) {
    const package::DirectoryEntry* e = package.find(type);
    if (!e || !package.head_valid(*e)) return {};
    const auto bytes = package.bytes(e);
    std::vector<T> out(bytes.size() / sizeof(T));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), out.size() * sizeof(T));
    return out;
}

}  // namespace vantage
