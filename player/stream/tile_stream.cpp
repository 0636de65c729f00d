#include "player/stream/tile_stream.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <ranges>

#include "base/text/error.h"
#include "base/values/tiling.h"
#include "scene/agreement/transient_weights.h"
#include "scene/package/contents/stored_tile.h"

namespace vantage {

TileStream::TileStream(const PackageReader& package, std::size_t ring_bytes, unsigned threads)
    : package_(package), ring_(ring_bytes) {
    if (package.remote())
        remote_ = std::make_unique<RemoteBytes>(package, [this] {
            { const std::scoped_lock lock(mutex_); }  // ensures that no worker is about to wait
            work_.notify_all();
        });
    for (unsigned i = 0; i < std::max(1u, threads); ++i)
        threads_.emplace_back([this](std::stop_token stop) { work(stop); });
}

TileStream::~TileStream() {
    for (std::jthread& t : threads_) t.request_stop();
    work_.notify_all();
    threads_.clear();
    remote_.reset();
}

void TileStream::want(std::span<const StreamRequest> requests) {
    {
        const std::scoped_lock lock(mutex_);
        wanted_.clear();
        for (const StreamRequest& r : std::views::reverse(requests))
            if (!begun_.contains(r.identity())) wanted_.push_back(r);
        if (remote_) remote_->want(std::vector(wanted_.rbegin(), wanted_.rend()));
    }
    work_.notify_all();
}

std::optional<Fetched> TileStream::take(std::size_t budget) {
    const std::scoped_lock lock(mutex_);
    if (done_.empty() || done_.front().bytes() > budget) return std::nullopt;
    const Fetched f = done_.front();
    done_.pop_front();
    begun_.erase(f.request.identity());
    return f;
}

void TileStream::release(const Fetched& fetched) {
    const std::scoped_lock lock(mutex_);
    if (fetched.piece) ring_.release(*fetched.piece);
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
    // A timeout is necessary: space in a full ring is freed by the graphics card, which does not signal
    // threads.
    fetched_.wait_for(lock, std::chrono::milliseconds(2), [&] { return !done_.empty() || idle(); });
    return !idle();
}

std::size_t TileStream::waiting() const {
    const std::scoped_lock lock(mutex_);
    return wanted_.size() + begun_.size();
}

std::string TileStream::failure() const {
    const std::scoped_lock lock(mutex_);
    return failure_;
}

StreamedSoFar TileStream::streamed() const {
    const std::scoped_lock lock(mutex_);
    return streamed_;
}

std::optional<TileStream::Task> TileStream::next_arrival() {
    std::optional<UploadRing::Piece> piece;
    auto arrival = remote_->take([&](const StreamRequest& r) {
        piece = ring_.take(std::size_t(r.size()));
        return piece.has_value();
    });
    if (!arrival) return {};
    std::erase_if(wanted_,
                  [&](const StreamRequest& r) { return r.identity() == arrival->request.identity(); });
    return Task{arrival->request, piece, std::move(arrival->held), std::move(arrival->failure)};
}

std::optional<TileStream::Task> TileStream::next_task() {
    if (remote_) return next_arrival();
    if (wanted_.empty()) return {};
    // A request is started only when the ring has space for it.
    const auto piece = ring_.take(std::size_t(wanted_.back().size()));
    if (!piece) return {};
    const StreamRequest request = wanted_.back();
    wanted_.pop_back();
    return Task{request, piece, {}, {}};
}

Fetched TileStream::carry_out(Task& task, std::uint64_t& read, std::stop_token stop) {
    using State = Fetched::State;
    if (!task.piece) return {task.request, {}, State::absent};
    try {
        const bool valid = fetch(task.request, ring_.memory(*task.piece), read, std::move(stop));
        return {task.request, task.piece, valid ? State::valid : State::damaged};
    } catch (const Error& e) {  // evicted before it was read
        task.failure = e.what();
        return {task.request, task.piece, State::absent};
    }
}

void TileStream::work(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    std::optional<Task> task;
    while (work_.wait(lock, stop, [&] { return (task = next_task()).has_value(); })) {
        begun_[task->request.identity()] = true;
        lock.unlock();
        const auto begin = std::chrono::steady_clock::now();
        StreamedSoFar done;
        const Fetched fetched = carry_out(*task, done.bytes, stop);
        done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        lock.lock();
        streamed_ = streamed_ + done;
        if (!task->failure.empty()) failure_ = task->failure;
        done_.push_back(fetched);
        task.reset();
        fetched_.notify_all();
    }
}

bool TileStream::fetch(const StreamRequest& r, std::span<std::byte> to, std::uint64_t& read,
                       std::stop_token stop) const {
    const auto copy = [&](std::span<const std::byte> from) {
        std::memcpy(to.data(), from.data(), from.size());
        read += from.size();
        package_.forget(from);
    };
    if (r.resource == Resource::thumbnail) {
        read += r.chunk->length;
        return read_thumbnail(package_, r.key, to);
    }
    if (r.bytes) {
        // The pieces of a chunk share its checksum, which is verified with the first piece.
        if (r.first == 0 && !package_.head_valid(*r.chunk) &&
            !(package_.fetch_again(*r.chunk) && package_.head_valid(*r.chunk)))
            return false;
        const auto content = package_.bytes(r.chunk);
        if (content.size() < r.first + r.bytes) return false;
        copy(content.subspan(r.first, r.bytes));
        return true;
    }
    if (r.resource == Resource::points) {
        if (!point_block_valid(r)) return false;
        copy(package_.block(*r.chunk, r.block));
        return true;
    }
    return fetch_tiles(r, to, read, std::move(stop));
}

bool TileStream::point_block_valid(const StreamRequest& r) const {
    const auto valid = [&] {
        return package_.head_valid(*r.chunk) && package_.block_valid(*r.chunk, r.block);
    };
    if (valid()) return true;
    const std::array parts{package_.head(*r.chunk), package_.block(*r.chunk, r.block)};
    return package_.discard(parts) && package_.hold(parts) && valid();
}

bool TileStream::fetch_tiles(const StreamRequest& r, std::span<std::byte> to, std::uint64_t& read,
                             std::stop_token stop) const {
    const std::vector<TilePlace> tiles = tiles_of(package_, r);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const TilePlace& t = tiles[i];
        const std::span<std::byte> texels = to.subspan(i * tile_bytes, tile_bytes);
        const bool valid = read_tile(package_, *t.chunk, t.level, t.tile, texels, stop);
        for (const auto& piece : stored_pieces(package_, *t.chunk, t.level, t.tile)) {
            read += piece.size();
            package_.forget(piece);
        }
        if (!valid) return false;
        if (i == 0 && r.reweighted) set_tile_weights(r.weights, t.level, r.block, texels);
    }
    return true;
}

}  // namespace vantage
