#include "scene/remote/remote_file.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "base/text/error.h"
#include "scene/remote/cache/blocks.h"
#include "scene/remote/cache/cache_folder.h"
#include "scene/remote/cache/cache_space.h"
#include "scene/remote/cache/cached_file.h"
#include "scene/remote/first_request.h"
#include "scene/remote/transfers.h"
#include "scene/remote/url.h"

namespace vantage {

namespace {

constexpr std::uint64_t max_request_blocks = (4 << 20) / block_bytes;  // 4 MiB
constexpr std::uint64_t max_first_bytes = 64 << 20;

TransferOptions transfer_options(const RemoteOptions& given) {
    return {given.connect_timeout, given.stall_timeout, given.retry_pause,
            std::clamp(given.max_requests, 1, 64), given.certificates};
}

std::uint64_t first_bytes(const RemoteOptions& given) {
    const std::uint64_t bytes = std::clamp<std::uint64_t>(given.first_bytes, 1, max_first_bytes);
    return number_of_blocks(bytes) * block_bytes;
}

}  // namespace

struct RemoteFile::Impl {
    struct Part;
    /// The parts that a call of fetch() waits for.
    using Parts = std::vector<std::shared_ptr<Part>>;

    Impl(std::string_view given_url, const RemoteOptions& options, std::stop_token stop);
    void open(std::uint64_t first, std::stop_token stop);
    void adopt(const FirstRequest& request, std::uint64_t first);

    std::vector<BlockRun> blocks_within(std::span<const ByteRange> ranges) const;
    std::uint64_t use(const std::vector<BlockRun>& runs);
    Parts request(const std::vector<BlockRun>& runs, const Kept& kept);
    void request_run(BlockRun run, const Kept& kept, Parts& parts);
    bool wait(const Parts& parts, std::stop_token stop);
    void abandon(const Parts& parts);

    const std::string url, shown;
    const CacheFolder folder;
    std::shared_ptr<CachedFile> file;
    std::optional<CacheSpace> space;
    Kept first_kept;
    std::atomic<bool> offline = false;
    std::atomic<std::uint64_t> bytes_from_cache = 0;

    std::mutex mutex;
    std::vector<bool> used;               ///< for each block: whether it was used; guarded by the mutex
    std::condition_variable_any changed;  ///< a part has finished
    std::unordered_map<std::uint64_t, std::shared_ptr<Part>> pending;  ///< by block; guarded by the mutex
    Transfers transfers;  ///< the last member, because its thread uses the others
};

/// A request for a run of blocks. The part keeps its blocks until the transfer thread is done, even if nobody
/// waits for them any longer.
struct RemoteFile::Impl::Part : Request {
    Part(Impl& owner, BlockRun blocks, std::uint64_t turn, Kept blocks_kept)
        : Request(bytes_of(blocks, owner.file->origin().size), turn),
          impl(owner),
          run(blocks),
          kept(std::move(blocks_kept)) {}

    std::string flaw(const Answer& answer, ByteRange asked) override {
        std::string flaw = flaw_of(answer, asked, &impl.file->origin());
        if (flaw.empty()) impl.offline = false;
        return flaw;
    }

    void store(std::uint64_t offset, std::span<const std::byte> bytes) override {
        impl.file->write(offset, bytes);
    }

    void done(const Failure* why) override {
        const std::scoped_lock lock(impl.mutex);
        if (why) failure = *why;
        finish();
    }

    /// Requires the mutex.
    void finish() {
        finished = true;
        for (std::uint64_t block = run.begin; block < run.end; ++block) {
            const auto found = impl.pending.find(block);
            if (found != impl.pending.end() && found->second.get() == this) impl.pending.erase(found);
        }
        impl.changed.notify_all();
    }

    Impl& impl;
    const BlockRun run;
    const Kept kept;
    // Guarded by the mutex.
    int waiting = 0;  ///< calls of fetch()
    bool finished = false;
    std::optional<Failure> failure;
};

RemoteFile::Impl::Impl(std::string_view given_url, const RemoteOptions& options, std::stop_token stop)
    : url(checked_url(given_url)),
      shown(shown_url(url)),
      folder(options.cache.empty() ? default_remote_cache() : options.cache),
      transfers(url, transfer_options(options)) {
    open(first_bytes(options), std::move(stop));
    space.emplace(folder, *file, options.cache_bytes);
    space->reserve(0);
    used.resize(file->table().blocks());
}

void RemoteFile::Impl::open(std::uint64_t first, std::stop_token stop) {
    file = folder.find(shown);
    bool usable = false;
    if (file) {
        const BlockRun run = blocks_of({0, std::min(first, file->origin().size)});
        first_kept = file->keep({run});
        usable = file->present(run);
    }
    const auto request = std::make_shared<FirstRequest>(first, shown, usable ? &file->origin() : nullptr);
    transfers.start(request, usable ? 1 : 3);
    if (!request->wait(std::move(stop))) {
        transfers.cancel(*request);
        throw Error(Exit::interrupted, shown + ": stopped while being opened");
    }
    if (const auto& failure = request->failure()) {
        if (!usable || !failure->unreachable) throw Error(failure->code, failure->message);
        offline = true;
    } else if (!request->unmodified()) {
        adopt(*request, first);
    }
}

/// Switches to the cached file for the server's version of the file, and stores the first bytes in it.
void RemoteFile::Impl::adopt(const FirstRequest& request, std::uint64_t first) {
    if (!file || !same_version(file->origin(), request.origin())) {
        first_kept.reset();
        file.reset();
        file = folder.find_or_make(request.origin());
    }
    const BlockRun run = blocks_of({0, std::min(first, file->origin().size)});
    first_kept = file->keep({run});
    if (file->present(run)) return;
    file->write(0, request.bytes());
    used.assign(run.end, true);  // not from the cache
}

std::vector<BlockRun> RemoteFile::Impl::blocks_within(std::span<const ByteRange> ranges) const {
    const std::uint64_t size = file->origin().size;
    for (const ByteRange& range : ranges)
        if (range.begin > range.end || range.end > size)
            throw Error(Exit::internal, shown + ": bytes " + std::to_string(range.begin) + " to " +
                                            std::to_string(range.end) + " are not within a file of " +
                                            std::to_string(size) + " bytes");
    return blocks_of(ranges);
}

/// Marks blocks as used, and counts the bytes that come from the cache; each block counts only once. Returns
/// the number of bytes that are absent.
std::uint64_t RemoteFile::Impl::use(const std::vector<BlockRun>& runs) {
    const std::scoped_lock lock(mutex);
    const std::uint32_t tick = file->table().tick();
    std::uint64_t absent = 0;
    for (const BlockRun& run : runs)
        for (std::uint64_t block = run.begin; block < run.end; ++block) {
            file->table().touch(block, tick);
            const std::uint64_t bytes = bytes_of({block, block + 1}, file->origin().size).size();
            if (!file->table().present(block))
                absent += bytes;
            else if (!used[block])
                bytes_from_cache += bytes;
            used[block] = true;
        }
    return absent;
}

/// Joins pending parts that fetch some of the blocks, and starts parts for the others.
RemoteFile::Impl::Parts RemoteFile::Impl::request(const std::vector<BlockRun>& runs, const Kept& kept) {
    Parts parts;
    const std::scoped_lock lock(mutex);
    for (const BlockRun& run : runs)
        for (std::uint64_t block = run.begin, end = 0; block < run.end; block = end) {
            end = block + 1;
            if (file->table().present(block)) continue;
            if (const auto found = pending.find(block); found != pending.end()) {
                parts.push_back(found->second);
                continue;
            }
            while (end < run.end && end - block < max_request_blocks && !file->table().present(end) &&
                   !pending.contains(end))
                ++end;
            request_run({block, end}, kept, parts);
        }
    std::ranges::sort(parts);
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    for (const auto& part : parts) ++part->waiting;
    return parts;
}

void RemoteFile::Impl::request_run(BlockRun run, const Kept& kept, Parts& parts) {
    const auto part = std::make_shared<Part>(*this, run, parts.size(), kept);
    for (std::uint64_t block = run.begin; block < run.end; ++block) pending.emplace(block, part);
    transfers.start(part);
    parts.push_back(part);
}

/// Waits for the parts. Returns false when stopped. Throws the first failure.
bool RemoteFile::Impl::wait(const Parts& parts, std::stop_token stop) {
    std::unique_lock lock(mutex);
    const auto failed = [](const auto& part) { return part->failure.has_value(); };
    const bool ended = changed.wait(lock, std::move(stop), [&] {
        return std::ranges::any_of(parts, failed) ||
               std::ranges::all_of(parts, [](const auto& part) { return part->finished; });
    });
    abandon(parts);
    const auto found = std::ranges::find_if(parts, failed);
    if (found != parts.end()) throw Error((*found)->failure->code, (*found)->failure->message);
    return ended;
}

/// Requires the mutex. Cancels the parts that nobody waits for any longer.
void RemoteFile::Impl::abandon(const Parts& parts) {
    for (const auto& part : parts)
        if (--part->waiting == 0 && !part->finished) {
            transfers.cancel(*part);
            part->finish();
        }
}

RemoteFile::RemoteFile(std::string_view url, const RemoteOptions& options, std::stop_token stop)
    : impl_(std::make_unique<Impl>(url, options, std::move(stop))) {}

RemoteFile::~RemoteFile() = default;
RemoteFile::RemoteFile(RemoteFile&&) noexcept = default;
RemoteFile& RemoteFile::operator=(RemoteFile&&) noexcept = default;

const std::string& RemoteFile::url() const { return impl_->shown; }
std::uint64_t RemoteFile::size() const { return impl_->file->origin().size; }
std::span<const std::byte> RemoteFile::bytes() const& { return impl_->file->bytes(); }
const std::filesystem::path& RemoteFile::path() const { return impl_->file->path(); }
bool RemoteFile::offline() const { return impl_->offline; }

bool RemoteFile::fetch(std::span<const ByteRange> ranges, std::stop_token stop) {
    const std::vector<BlockRun> runs = impl_->blocks_within(ranges);
    const Kept kept = impl_->file->keep(runs);
    const std::uint64_t absent = impl_->use(runs);
    if (absent == 0) return true;

    struct Reservation {
        CacheSpace& space;
        std::uint64_t bytes;
        Reservation(CacheSpace& in, std::uint64_t n) : space(in), bytes(n) { space.reserve(bytes); }
        ~Reservation() { space.settle(bytes); }
    };
    const Reservation reservation(*impl_->space, absent);
    return impl_->wait(impl_->request(runs, kept), std::move(stop));
}

bool RemoteFile::present(ByteRange range) const {
    const auto runs = impl_->blocks_within({&range, 1});
    return std::ranges::all_of(runs, [&](const BlockRun& run) { return impl_->file->present(run); });
}

void RemoteFile::discard(ByteRange range) {
    for (const BlockRun& run : impl_->blocks_within({&range, 1}))
        for (std::uint64_t block = run.begin; block < run.end; ++block) impl_->file->table().clear(block);
}

std::shared_ptr<const void> RemoteFile::keep(std::span<const ByteRange> ranges) {
    return impl_->file->keep(impl_->blocks_within(ranges));
}

Traffic RemoteFile::traffic() const {
    return {impl_->transfers.bytes_received(), impl_->transfers.requests(), impl_->bytes_from_cache,
            impl_->transfers.bytes_per_second()};
}

}  // namespace vantage
