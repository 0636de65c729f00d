#include "player/stream/tile_stream.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "agreement/consensus_weights.h"
#include "scene/stored_tile.h"
#include "scene/tiling.h"

namespace vantage {

std::uint64_t StreamRequest::size() const {
    if (bytes) return bytes;
    if (resource == Resource::points) return chunk->block_length;
    return second ? 2 * tile_bytes : tile_bytes;
}

TileStream::TileStream(const PackageReader& package, std::size_t ring_bytes, unsigned threads)
    : package_(package), ring_(ring_bytes) {
    for (unsigned i = 0; i < std::max(1u, threads); ++i)
        threads_.emplace_back([this](std::stop_token stop) { work(stop); });
}

TileStream::~TileStream() {
    for (std::jthread& t : threads_) t.request_stop();
    work_.notify_all();
    threads_.clear();
}

void TileStream::want(std::span<const StreamRequest> requests) {
    {
        const std::scoped_lock lock(mutex_);
        wanted_.clear();
        for (const StreamRequest& r : requests)
            if (!begun_.contains(r.identity())) wanted_.push_back(r);
    }
    work_.notify_all();
}

std::optional<Fetched> TileStream::take(std::size_t budget) {
    const std::scoped_lock lock(mutex_);
    if (done_.empty() || done_.front().piece.bytes > budget) return std::nullopt;
    const Fetched f = done_.front();
    done_.pop_front();
    begun_.erase(f.request.identity());
    return f;
}

void TileStream::release(const Fetched& fetched) {
    const std::scoped_lock lock(mutex_);
    ring_.release(fetched.piece);
}

void TileStream::fence() {
    {
        const std::scoped_lock lock(mutex_);
        ring_.fence();
    }
    work_.notify_all();
}

bool TileStream::wait() {
    std::unique_lock lock(mutex_);
    const auto idle = [&] { return wanted_.empty() && begun_.empty(); };
    // With a timeout: space in a full ring is freed by the graphics card, which signals no thread.
    fetched_.wait_for(lock, std::chrono::milliseconds(2), [&] { return !done_.empty() || idle(); });
    return !idle();
}

std::size_t TileStream::waiting() const {
    const std::scoped_lock lock(mutex_);
    return wanted_.size() + begun_.size();
}

std::uint64_t TileStream::bytes_read() const {
    const std::scoped_lock lock(mutex_);
    return bytes_read_;
}

void TileStream::work(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    std::optional<UploadRing::Piece> piece;
    // A request is started only when the ring has space for it.
    const auto can_begin = [&] {
        if (!wanted_.empty()) piece = ring_.take(std::size_t(wanted_.front().size()));
        return piece.has_value();
    };
    while (work_.wait(lock, stop, can_begin)) {
        const StreamRequest request = wanted_.front();
        wanted_.pop_front();
        begun_[request.identity()] = true;
        const std::span<std::byte> to = ring_.memory(*piece);
        lock.unlock();
        std::uint64_t read = 0;
        const bool sound = fetch(request, to, read);
        lock.lock();
        bytes_read_ += read;
        done_.push_back({request, *piece, sound});
        piece.reset();
        fetched_.notify_all();
    }
}

bool TileStream::fetch(const StreamRequest& r, std::span<std::byte> to, std::uint64_t& read) const {
    const auto copy = [&](std::span<const std::byte> from, std::size_t at) {
        std::memcpy(to.data() + at, from.data(), from.size());
        read += from.size();
        package_.forget(from);
    };
    if (r.resource == Resource::thumbnail) {
        read += r.chunk->length;
        return read_thumbnail(package_, r.key, to);
    }
    if (r.bytes) {
        // The pieces of a chunk share its checksum, which the first piece checks.
        if (r.first == 0 && !package_.head_sound(*r.chunk)) return false;
        copy(package_.bytes(r.chunk).subspan(r.first, r.bytes), 0);
        return true;
    }
    if (r.resource == Resource::points) {
        if (!package_.block_sound(*r.chunk, r.block)) return false;
        copy(package_.block(*r.chunk, r.block), 0);
        return true;
    }
    const package::PhotoRecord& p = package_.photos()[r.chunk->photo];
    const Level level = level_size(int(p.width), int(p.height), int(r.chunk->level));
    const auto tile = [&](const package::DirectoryEntry& chunk, std::size_t at) {
        const bool sound = read_tile(package_, chunk, level, r.block, to.subspan(at, tile_bytes));
        for (const auto& piece : stored_pieces(package_, chunk, level, r.block)) {
            read += piece.size();
            package_.forget(piece);
        }
        return sound;
    };
    if (!tile(*r.chunk, 0)) return false;
    if (r.reweighted) set_tile_weights(r.weights, level, r.block, to.first(tile_bytes));
    return !r.second || tile(*r.second, tile_bytes);
}

}  // namespace vantage
