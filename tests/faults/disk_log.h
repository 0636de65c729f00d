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
    std::uint64_t offset;  ///< of the data; size: the new size
    std::string path, other, data;
};
std::vector<DiskOperation> read_disk_log(const std::filesystem::path& file);

/// Contents by path.
using Files = std::map<std::string, std::string>;
Files files_below(const std::filesystem::path& folder);
/// Replaces all files of the folder.
void restore(const std::filesystem::path& folder, const Files& files);

/// What a power cut after these operations leaves, if `before` was on the disk. Files hold what was flushed,
/// and of later writes and sizes any selection, whole or only some pages; names change in order, all that
/// were flushed with their folder and any number of the later ones.
Files after_power_cut(const Files& before, std::span<const DiskOperation> operations, std::mt19937& random);

}  // namespace vantage
