#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace vantage {

/// An operation that changed a file, recorded by faulty_disk.cpp.
struct DiskOperation {
    enum class Kind : char { create = 'c', write = 'w', size = 's', flush = 'f', rename = 'r', remove = 'u' };
    Kind kind;
    std::uint64_t offset;  ///< offset of the data; if `kind` is `size`, the new size of the file
    std::string path, other, data;
};
std::vector<DiskOperation> read_disk_log(const std::filesystem::path& file);

/// File contents by path.
using Files = std::map<std::string, std::string>;
Files files_below(const std::filesystem::path& folder);
/// Replaces all files in the folder.
void restore(const std::filesystem::path& folder, const Files& files);

/// A possible state of the disk after these operations and a power cut, starting from `before`. Files contain
/// all flushed data and a random selection of the later writes and size changes. Each of these writes is
/// either complete or has reached the disk only in part. Changes to names take effect in order: all changes
/// that were flushed with their folder, and any number of later changes.
Files after_power_cut(const Files& before, std::span<const DiskOperation> operations, std::mt19937& random);

}  // namespace vantage
