#include "scene/package/contents/zstd_chunk.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "scene/codec/zstd_bytes.h"
#include "scene/package/package_format.h"

namespace vantage {
namespace {

constexpr int zstd_level = 6;

}  // namespace

std::vector<std::byte> zstd_chunk(std::span<const std::byte> content) {
    const std::uint64_t length = content.size();
    const std::vector<std::byte> frame = codec::compress(content, zstd_level);
    std::vector<std::byte> out(
        std::max<std::size_t>(sizeof length + frame.size(), length / package::max_expansion + 1));
    std::memcpy(out.data(), &length, sizeof length);
    std::ranges::copy(frame, out.begin() + sizeof length);
    if (out.size() >= content.size()) out.clear();
    return out;
}

std::vector<std::byte> content_of_zstd(std::span<const std::byte> chunk) {
    std::uint64_t length;
    std::memcpy(&length, chunk.data(), sizeof length);
    if (length / package::max_expansion > chunk.size()) return {};
    std::vector<std::byte> content(length);
    if (!codec::decompress(chunk.subspan(sizeof length), content)) content.clear();
    return content;
}

}  // namespace vantage
