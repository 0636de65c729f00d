#include "scene/package/mismatches.h"

#include <algorithm>

namespace vantage {
namespace {

constexpr std::uint64_t held_at_once = 16 << 20;  ///< bytes of blocks, if the package is on a server

void add_block_mismatches(const PackageReader& package, const package::DirectoryEntry& e, std::size_t most,
                          std::vector<Mismatch>& out) {
    const auto body = package.raw(e).subspan(e.head_length);
    std::uint64_t end = 0;  ///< where the bytes that are held end
    Held held;
    for (std::size_t b = 0; b < package.blocks(e) && out.size() < most; ++b) {
        const auto block = package.block(e, b);
        const auto last = block.empty() ? 0 : std::uint64_t(block.data() - body.data()) + block.size();
        if (last > end) {
            const std::uint64_t begin = last - block.size();
            const auto next = body.subspan(
                begin, std::min(body.size() - begin, std::max<std::uint64_t>(held_at_once, block.size())));
            held = package.hold({&next, 1});
            end = begin + next.size();
        }
        if (!package.block_valid(e, b)) out.push_back({Defect::tile_checksum, tile_mismatch(package, e, b)});
    }
}

}  // namespace

std::string tile_mismatch(const PackageReader& reader, const package::DirectoryEntry& e, std::size_t tile) {
    return describe(e, reader) + ": tile " + std::to_string(tile) + " of " +
           std::to_string(reader.blocks(e)) + ": checksum does not match";
}

std::vector<Mismatch> mismatches(const PackageReader& package, bool tiles, std::size_t most) {
    std::vector<Mismatch> out;
    for (const package::DirectoryEntry& e : package.directory()) {
        const auto head = package.head(e);
        const Held held = package.hold({&head, 1});
        const bool valid = package.head_valid(e);
        if (!valid)
            out.push_back({Defect::chunk_checksum, describe(e, package) + ": checksum does not match"});
        if (tiles && valid) add_block_mismatches(package, e, most, out);
        if (tiles) package.forget(package.raw(e));
        if (out.size() >= most) break;
    }
    return out;
}

void expect_valid(const PackageReader& package) {
    for (const Mismatch& m : mismatches(package, true, 1))
        throw DamagedPackage(m.defect, package.path().string() + ": " + m.text);
}

}  // namespace vantage
