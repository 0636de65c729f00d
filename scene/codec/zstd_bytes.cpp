#include "scene/codec/zstd_bytes.h"

#include <zstd.h>

#include <memory>
#include <new>

namespace vantage::codec {
namespace {

struct Free {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

std::vector<std::byte> compress(std::span<const std::byte> bytes, int level) {
    thread_local const std::unique_ptr<ZSTD_CCtx, Free> context(ZSTD_createCCtx());
    if (!context) throw std::bad_alloc();
    std::vector<std::byte> out(ZSTD_compressBound(bytes.size()));
    const std::size_t n =
        ZSTD_compressCCtx(context.get(), out.data(), out.size(), bytes.data(), bytes.size(), level);
    if (ZSTD_isError(n)) throw std::bad_alloc();  // the only possible error with enough space
    out.resize(n);
    return out;
}

std::optional<std::size_t> decompress_up_to(std::span<const std::byte> frame, std::span<std::byte> to) {
    thread_local const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
    if (!context) throw std::bad_alloc();
    const std::size_t length = ZSTD_findFrameCompressedSize(frame.data(), frame.size());
    if (ZSTD_isError(length)) return std::nullopt;
    const std::size_t n = ZSTD_decompressDCtx(context.get(), to.data(), to.size(), frame.data(), length);
    return ZSTD_isError(n) ? std::nullopt : std::optional(n);
}

bool decompress(std::span<const std::byte> frame, std::span<std::byte> to) {
    return decompress_up_to(frame, to) == to.size();
}

}  // namespace vantage::codec
