#include "scene/remote/cache/cached_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <algorithm>
#include <vector>

#include "base/files/descriptor.h"
#include "base/files/replace_file.h"
#include "scene/remote/cache/storage_error.h"

namespace vantage {

namespace {

std::uint64_t hash_of(const Origin& origin) {
    const std::string text = text_of(origin);
    return XXH3_64bits(text.data(), text.size());
}

}  // namespace

std::string origin_text(const std::filesystem::path& folder) {
    constexpr std::size_t max_bytes = 64 << 10;
    const Descriptor fd(
        ::open((folder / cached::origin).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    struct stat st {};
    if (!fd || ::fstat(fd.get(), &st) != 0 || !S_ISREG(st.st_mode)) return {};
    std::string content(max_bytes, '\0');
    const ssize_t n = ::pread(fd.get(), content.data(), content.size(), 0);
    content.resize(n < 0 ? 0 : std::size_t(n));
    return content;
}

CachedFile::CachedFile(std::filesystem::path folder, Origin origin, MappedFile data, BlockTable table)
    : folder_(std::move(folder)),
      path_(folder_ / cached::data),
      origin_(std::move(origin)),
      data_(std::move(data)),
      table_(std::move(table)),
      holds_(table_.file().descriptor()) {
    if (::flock(data_.descriptor(), LOCK_SH) != 0) throw storage_error(path_, "lock");
    note_use();
}

CachedFile::~CachedFile() { note_use(); }

void CachedFile::note_use() const {
    ::utimensat(AT_FDCWD, (folder_ / cached::origin).c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
}

std::shared_ptr<CachedFile> CachedFile::open(const std::filesystem::path& folder) {
    auto origin = parse_origin(origin_text(folder));
    if (!origin) return {};
    auto table = BlockTable::open(folder / cached::table, number_of_blocks(origin->size), hash_of(*origin));
    auto data = MappedFile::open(folder / cached::data, origin->size, false);
    if (!table || !data) return {};
    return std::shared_ptr<CachedFile>(
        new CachedFile(folder, std::move(*origin), std::move(data), std::move(*table)));
}

std::shared_ptr<CachedFile> CachedFile::create(const std::filesystem::path& folder, const Origin& origin) {
    // The origin is written first, to mark the folder as ours.
    replace_file(folder / cached::origin, text_of(origin), 0600);
    auto data = MappedFile::create(folder / cached::data, origin.size, false, false);
    auto table = BlockTable::create(folder / cached::table, number_of_blocks(origin.size), hash_of(origin));
    return std::shared_ptr<CachedFile>(new CachedFile(folder, origin, std::move(data), std::move(table)));
}

bool CachedFile::present(BlockRun run) const {
    for (std::uint64_t block = run.begin; block < run.end; ++block)
        if (!table_.present(block)) return false;
    return true;
}

void CachedFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    const std::uint64_t end = offset + bytes.size();
    for (std::uint64_t at = offset; at < end;) {
        const auto rest = bytes.subspan(at - offset);
        const ssize_t written = ::pwrite(data_.descriptor(), rest.data(), rest.size(), off_t(at));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw storage_error(path_, "write");
        at += std::uint64_t(written);
    }
    const std::uint64_t complete = end == origin_.size ? table_.blocks() : end / block_bytes;
    const std::uint32_t tick = table_.tick();
    for (std::uint64_t block = offset / block_bytes; block < complete; ++block) table_.mark(block, tick);
}

Kept CachedFile::keep(std::vector<BlockRun> runs) {
    struct Hold {
        std::shared_ptr<CachedFile> file;
        std::vector<BlockRun> runs;
        ~Hold() { file->holds_.release(runs); }
    };
    holds_.hold(runs);
    return Kept(new Hold{shared_from_this(), std::move(runs)});
}

/// The blocks that have bytes on the disk: those that are present, and remains of unfinished fetches.
std::vector<BlockRun> CachedFile::on_disk() const {
    std::vector<ByteRange> ranges;
    for (off_t at = 0;;) {
        const off_t begin = ::lseek(data_.descriptor(), at, SEEK_DATA);
        const off_t end = begin < 0 ? -1 : ::lseek(data_.descriptor(), begin, SEEK_HOLE);
        if (end < 0) return blocks_of(ranges);
        ranges.push_back({std::uint64_t(begin), std::uint64_t(end)});
        at = end;
    }
}

bool CachedFile::free(std::uint64_t block) {
    table_.clear(block);  // first, so that a process killed here leaves data without a mark
    // The range extends beyond the end of the last block, so that its last page is freed as well.
    return ::fallocate(data_.descriptor(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                       off_t(block * block_bytes), off_t(block_bytes)) == 0;
}

std::uint64_t CachedFile::evict(std::uint64_t bytes) {
    const std::scoped_lock lock(evicting_);
    struct Use {
        std::uint32_t tick;
        std::uint64_t block;
    };
    std::vector<Use> uses;
    for (const BlockRun& run : on_disk())
        for (std::uint64_t block = run.begin; block < run.end; ++block)
            uses.push_back({table_.last_use(block), block});
    std::ranges::sort(uses, {}, &Use::tick);
    std::uint64_t freed = 0;
    for (const Use& use : uses) {
        if (freed >= bytes) break;
        errno = 0;
        if (holds_.if_unheld(use.block, [&] { return free(use.block); }))
            freed += use.tick ? block_bytes : 0;  // others may have little on the disk
        else if (errno == EOPNOTSUPP)
            throw storage_error(path_, "free a part of the file");
    }
    return freed;
}

std::uint64_t CachedFile::disk_bytes() const { return data_.disk_bytes() + table_.file().disk_bytes(); }

}  // namespace vantage
