#include "scene/package/package_layout.h"

#include "base/files/checksum.h"
#include "base/values/bytes_of.h"

namespace vantage {

using package::aligned;
using package::DirectoryEntry;

namespace {

DirectoryEntry planned_entry(const ChunkPlan& plan, std::uint64_t offset) {
    DirectoryEntry e{};
    e.type = std::uint32_t(plan.type);
    e.version = 1;
    e.photo = plan.photo;
    e.level = plan.level;
    e.offset = offset;
    e.head_length = plan.blocks ? aligned(plan.blocks * sizeof(std::uint64_t)) : plan.bytes;
    e.block_length = plan.blocks ? plan.block_length : 0;
    e.length = e.head_length + plan.blocks * e.block_length;
    return e;
}

/// Ignores the positions of scene-wide chunks. Every run rewrites these chunks, so they do not affect which
/// chunks can be kept.
std::uint64_t layout_checksum(const PackageLayout& layout, std::uint64_t names) {
    std::vector<std::uint64_t> words{names, layout.bytes, layout.directory.size(), layout.compact()};
    for (const DirectoryEntry& e : layout.directory) {
        words.push_back(std::uint64_t(e.type) << 32 | e.level);
        if (e.photo == package::scene_wide) continue;
        words.insert(words.end(), {e.photo, e.offset, e.length});
    }
    return checksum(bytes_of(words));
}

}  // namespace

PackageLayout package_layout(std::span<const ChunkPlan> plan, std::uint64_t names) {
    PackageLayout out;
    // The directory has space for one more entry, that of an appended chunk.
    out.bytes = aligned(sizeof(package::Header) + (plan.size() + 1) * sizeof(DirectoryEntry));
    for (const ChunkPlan& chunk : plan) {
        out.directory.push_back(planned_entry(chunk, out.bytes));
        const std::uint64_t length = aligned(out.directory.back().length);
        out.bytes += length;
        if (chunk.compact) out.compact_bytes += length;
    }
    out.checksum = layout_checksum(out, names);
    return out;
}

}  // namespace vantage
