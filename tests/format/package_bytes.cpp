#include "package_bytes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "xxhash.h"
#include "zstd.h"

namespace independent {

void require(bool condition, const std::string& what) {
    if (!condition) throw std::runtime_error(what);
}

Bytes slice(Bytes bytes, uint64_t offset, uint64_t length) {
    require(offset <= bytes.size() && length <= bytes.size() - offset,
            "a range extends beyond its container");
    return bytes.subspan(offset, length);
}

namespace {

uint64_t checksum(Bytes bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

Bytes map_file(const char* path) {
    const int file = open(path, O_RDONLY);
    struct stat status = {};
    require(file >= 0 && fstat(file, &status) == 0 && status.st_size > 0, "cannot be read or is empty");
    const auto size = static_cast<size_t>(status.st_size);
    const void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    close(file);
    require(data != MAP_FAILED, "cannot be mapped");
    return {static_cast<const uint8_t*>(data), size};
}

Entry read_entry(Bytes file, Bytes bytes) {
    const auto offset = number_at<uint64_t>(bytes, 16);
    const Entry entry = {.type = std::string(bytes.begin(), bytes.begin() + 4),
                         .version = number_at<uint32_t>(bytes, 4),
                         .photo = number_at<uint32_t>(bytes, 8),
                         .level = number_at<uint32_t>(bytes, 12),
                         .form = number_at<uint32_t>(bytes, 56),
                         .blocks = number_at<uint32_t>(bytes, 60),
                         .head_length = number_at<uint64_t>(bytes, 32),
                         .block_length = number_at<uint64_t>(bytes, 40),
                         .checksum = number_at<uint64_t>(bytes, 48),
                         .bytes = slice(file, offset, number_at<uint64_t>(bytes, 24))};
    const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    require(std::ranges::all_of(entry.type, letter), "a type does not consist of letters");
    require(offset % (entry.form == 0 ? 4096 : 8) == 0, "a chunk is not aligned");
    return entry;
}

}  // namespace

Package read_package(const char* path) try {
    const Bytes file = map_file(path), header = slice(file, 0, 64);
    const std::string_view magic = "VANTAGE\n";
    require(std::equal(magic.begin(), magic.end(), header.begin()), "not a finished package");
    require(number_at<uint32_t>(header, 8) == 8, "not format version 8");
    require(number_at<uint64_t>(header, 56) == checksum(header.first(56)), "the header is damaged");
    require(number_at<uint64_t>(header, 24) == file.size(), "the file does not have the stated size");
    const Bytes directory =
        slice(file, number_at<uint64_t>(header, 16), uint64_t{64} * number_at<uint32_t>(header, 12));
    require(number_at<uint64_t>(header, 32) == checksum(directory), "the directory is damaged");
    Package package;
    for (size_t at = 0; at < directory.size(); at += 64) {
        const Entry entry = read_entry(file, directory.subspan(at, 64));
        package.try_emplace({entry.type, entry.photo, entry.level}, entry);
    }
    return package;
} catch (const std::exception& error) {
    throw std::runtime_error(std::string(path) + ": " + error.what());
}

const Entry& chunk_of(const Package& package, const std::string& type, uint32_t photo, uint32_t level) {
    const auto found = package.find({type, photo, level});
    require(found != package.end(), "there is no matching chunk of type " + type);
    return found->second;
}

Chunk open_chunk(const Entry& entry) {
    require(entry.version == 1 && entry.form <= 5, "unknown version or form");
    Chunk chunk = {.head = slice(entry.bytes, 0, entry.head_length), .shared = {}, .blocks = {}};
    require(checksum(chunk.head) == entry.checksum, "the head is damaged");
    const Bytes behind = entry.bytes.subspan(entry.head_length);
    const bool raw_form = entry.form == 0;
    const uint64_t raw_blocks = entry.block_length > 0 ? behind.size() / entry.block_length : 0;
    const uint64_t n = raw_form ? raw_blocks : entry.blocks;
    const Bytes table = slice(chunk.head, 0, (raw_form ? 8 : 16) * n);
    uint64_t end = 0;
    for (uint64_t i = 0; i < n; ++i) {
        const uint64_t begin =
            std::exchange(end, raw_form ? end + entry.block_length : number_at<uint64_t>(table, 8 * (n + i)));
        require(begin <= end, "a block ends before it begins");
        chunk.blocks.push_back(slice(behind, begin, end - begin));
        require(number_at<uint64_t>(table, 8 * i) == checksum(chunk.blocks.back()), "a block is damaged");
    }
    require(end == behind.size(), "there are bytes outside the blocks");
    chunk.shared = chunk.head.subspan(table.size());
    return chunk;
}

Buffer unzip(Bytes bytes, uint64_t most, bool padded) {
    const size_t length = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
    require(!ZSTD_isError(length) && length <= bytes.size(), "not a zstd frame");
    const Bytes rest = bytes.subspan(length);
    require(std::ranges::count(rest, 0) == std::ssize(rest) && (padded || rest.empty()),
            "there are bytes after a frame");
    Buffer content(most);
    const size_t written = ZSTD_decompress(content.data(), content.size(), bytes.data(), length);
    require(!ZSTD_isError(written), "a zstd frame is damaged or too long");
    content.resize(written);
    return content;
}

Buffer read_content(const Entry& entry) {
    const Bytes head = open_chunk(entry).head;
    require(entry.form <= 1 && head.size() == entry.bytes.size(), "a chunk should have no blocks");
    if (entry.form == 0) return Buffer(head.begin(), head.end());
    const auto length = number_at<uint64_t>(head, 0);
    // The length is checked before memory is allocated for the content.
    require(length / 32 <= head.size(), "a chunk's content is too long");
    Buffer content = unzip(head.subspan(8), length, true);
    require(content.size() == length, "a chunk's content does not have its stated length");
    return content;
}

}  // namespace independent
