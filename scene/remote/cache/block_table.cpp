#include "scene/remote/cache/block_table.h"

#include <cstring>

namespace vantage {

namespace {

struct Header {
    char magic[8];
    std::uint32_t version, tick;
    std::uint64_t blocks, origin;
};
static_assert(sizeof(Header) == 32);

Header header_for(std::uint64_t blocks, std::uint64_t origin) {
    Header header{{}, 1, 0, blocks, origin};
    std::memcpy(header.magic, "VNTGBLKS", 8);
    return header;
}

std::uint64_t bytes_for(std::uint64_t blocks) { return sizeof(Header) + blocks * sizeof(std::uint32_t); }

}  // namespace

std::optional<BlockTable> BlockTable::open(const std::filesystem::path& path, std::uint64_t blocks,
                                           std::uint64_t origin) {
    MappedFile file = MappedFile::open(path, bytes_for(blocks), true);
    if (!file) return {};
    Header found{}, expected = header_for(blocks, origin);
    std::memcpy(&found, file.data(), sizeof found);
    expected.tick = found.tick;
    if (std::memcmp(&found, &expected, sizeof found) != 0) return {};
    return BlockTable(std::move(file), blocks);
}

BlockTable BlockTable::create(const std::filesystem::path& path, std::uint64_t blocks, std::uint64_t origin) {
    MappedFile file = MappedFile::create(path, bytes_for(blocks), true, true);
    const Header header = header_for(blocks, origin);
    std::memcpy(file.data(), &header, sizeof header);
    return {std::move(file), blocks};
}

std::atomic_ref<std::uint32_t> BlockTable::mark_of(std::uint64_t block) const {
    return std::atomic_ref(reinterpret_cast<std::uint32_t*>(file_.data() + sizeof(Header))[block]);
}

std::uint32_t BlockTable::last_use(std::uint64_t block) const {
    return mark_of(block).load(std::memory_order_acquire);
}

std::uint32_t BlockTable::tick() {
    std::atomic_ref last(reinterpret_cast<Header*>(file_.data())->tick);
    const std::uint32_t next = last.fetch_add(1) + 1;
    return next ? next : 1;
}

void BlockTable::mark(std::uint64_t block, std::uint32_t tick) {
    mark_of(block).store(tick, std::memory_order_release);
}

void BlockTable::touch(std::uint64_t block, std::uint32_t tick) {
    std::uint32_t last = last_use(block);
    if (last != 0) mark_of(block).compare_exchange_strong(last, tick);
}

}  // namespace vantage
