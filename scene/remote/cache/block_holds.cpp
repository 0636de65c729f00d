#include "scene/remote/cache/block_holds.h"

#include <fcntl.h>

#include <cerrno>
#include <cstring>

#include "base/text/error.h"

namespace vantage {

bool BlockHolds::lock(short type, BlockRun run, bool wait) const {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = off_t(run.begin);
    lock.l_len = off_t(run.size());
    int result = 0;
    do result = ::fcntl(fd_, wait ? F_OFD_SETLKW : F_OFD_SETLK, &lock);
    while (result != 0 && errno == EINTR);
    return result == 0;
}

void BlockHolds::hold(std::span<const BlockRun> runs) {
    const std::scoped_lock guard(mutex_);
    for (const BlockRun& run : runs)
        if (!lock(F_RDLCK, run, true))
            throw Error(Exit::storage,
                        std::string("cannot lock a file in the cache: ") + std::strerror(errno));
    for (const BlockRun& run : runs)
        for (std::uint64_t block = run.begin; block < run.end; ++block) ++held_[block];
}

void BlockHolds::release(std::span<const BlockRun> runs) {
    const std::scoped_lock guard(mutex_);
    for (const BlockRun& run : runs)
        for (std::uint64_t block = run.begin; block < run.end; ++block) {
            const auto found = held_.find(block);
            if (--found->second > 0) continue;
            held_.erase(found);
            lock(F_UNLCK, {block, block + 1}, false);
        }
}

bool BlockHolds::if_unheld(std::uint64_t block, const std::function<bool()>& free) {
    const std::scoped_lock guard(mutex_);
    const BlockRun run{block, block + 1};
    if (held_.contains(block) || !lock(F_WRLCK, run, false)) return false;
    const bool freed = free();
    lock(F_UNLCK, run, false);
    return freed;
}

}  // namespace vantage
