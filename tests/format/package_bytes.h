#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

// A package as described in the first part of scene/package/FORMAT.md: header, directory and chunks.
namespace independent {

using Bytes = std::span<const uint8_t>;
using Buffer = std::vector<uint8_t>;

// Throws an error with this message unless the condition holds.
void require(bool condition, const std::string& what);

Bytes slice(Bytes bytes, uint64_t offset, uint64_t length);

template <typename T>
T number_at(Bytes bytes, uint64_t offset) {
    T value = 0;
    const Bytes field = slice(bytes, offset, sizeof(T));
    for (size_t i = 0; i < sizeof(T); ++i) value = static_cast<T>(value | T{field[i]} << 8 * i);
    return value;
}

inline uint64_t divided_up(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

struct Entry {
    std::string type;
    uint32_t version, photo, level, form, blocks;
    uint64_t head_length, block_length, checksum;
    Bytes bytes;
};

using Package = std::map<std::tuple<std::string, uint32_t, uint32_t>, Entry>;  // by type, photo, level

struct Chunk {
    Bytes head, shared;
    std::vector<Bytes> blocks;
};

// Reads the header and the directory. The file stays mapped until the program ends.
Package read_package(const char* path);

const Entry& chunk_of(const Package& package, const std::string& type, uint32_t photo, uint32_t level);

// Splits a chunk into its head and its blocks, and verifies the checksums.
Chunk open_chunk(const Entry& entry);

// The content of a zstd frame, at most `most` bytes. `padded`: zeros may follow the frame.
Buffer unzip(Bytes bytes, uint64_t most, bool padded);

// The content of a chunk without blocks.
Buffer read_content(const Entry& entry);

}  // namespace independent
