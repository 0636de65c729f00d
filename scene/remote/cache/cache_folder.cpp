#include "scene/remote/cache/cache_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <algorithm>
#include <vector>

#include "base/files/replace_file.h"
#include "base/files/xdg_folder.h"
#include "scene/remote/cache/storage_error.h"

namespace vantage {

namespace fs = std::filesystem;

namespace {

/// Whether the file is a temporary file that was left by a crash while the origin was being written.
bool is_unfinished_origin(const fs::path& file) {
    return file.filename().string().starts_with(std::string(cached::origin).append(unfinished_mark));
}

/// The files in one of our folders, in the order in which they are deleted. The origin, which marks the
/// folder as ours, comes last.
std::vector<fs::path> files_of_ours(const fs::path& folder) {
    std::vector<fs::path> files{folder / cached::table, folder / cached::data};
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (is_unfinished_origin(entry->path())) files.push_back(entry->path());
    files.push_back(folder / cached::origin);
    return files;
}

std::string folder_name(const std::string& url, std::uint64_t seed) {
    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, XXH3_128bits_withSeed(url.data(), url.size(), seed));
    std::string name;
    for (const unsigned char byte : bytes.digest)
        for (const int digit : {byte >> 4, byte & 15}) name += "0123456789abcdef"[digit];
    return name;
}

bool named_like_ours(const fs::path& folder) {
    const std::string name = folder.filename().string();
    return name.size() == 32 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() == fs::file_type::directory;
}

bool ours(const fs::path& folder) { return is_folder(folder) && begins_like_origin(origin_text(folder)); }

/// True if the folder is empty or has only files that were left by a crash.
bool unclaimed(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (!is_unfinished_origin(entry->path())) return false;
    return !error && is_folder(folder);
}

void drop(const fs::path& folder) {
    for (const fs::path& file : files_of_ours(folder)) ::unlink(file.c_str());
}

/// True if no process has the file open.
bool unused(const fs::path& folder) {
    const Descriptor data(
        ::open((folder / cached::data).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    return !data || ::flock(data.get(), LOCK_EX | LOCK_NB) == 0;
}

struct Usage {
    fs::path folder;
    std::uint64_t bytes = 0;  ///< on the disk
    timespec used{};          ///< last time
};

Usage usage_of(const fs::path& folder) {
    Usage usage{folder};
    for (const fs::path& file : files_of_ours(folder)) {
        struct stat st {};
        if (::lstat(file.c_str(), &st) != 0) continue;
        usage.bytes += std::uint64_t(st.st_blocks) * 512;
        if (file.filename() == cached::origin) usage.used = st.st_mtim;
    }
    return usage;
}

}  // namespace

fs::path default_remote_cache() {
    const fs::path folder = xdg_folder("XDG_CACHE_HOME", ".cache");
    return folder.empty() ? folder : folder / "remote";
}

CacheFolder::CacheFolder(fs::path root) : root_(std::move(root)) {
    if (root_.empty())
        throw Error(Exit::storage, "no folder for the cache of remote files: set XDG_CACHE_HOME or HOME");
    std::error_code error;
    fs::create_directories(root_, error);
    if (error) throw Error(Exit::storage, root_.string() + ": cannot create: " + error.message());
}

Descriptor CacheFolder::lock() const {
    const fs::path path = root_ / "lock";
    Descriptor fd(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!fd) throw storage_error(path, "open");
    int result = 0;
    do result = ::flock(fd.get(), LOCK_EX);
    while (result != 0 && errno == EINTR);
    if (result != 0) throw storage_error(path, "lock");
    return fd;
}

/// The folder for a URL. This folder is ours, empty or missing; folders that other programs use are skipped.
fs::path CacheFolder::folder_of(const std::string& url) const {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        fs::path folder = root_ / folder_name(url, seed);
        std::error_code error;
        if (!fs::exists(fs::symlink_status(folder, error)) || ours(folder) || unclaimed(folder))
            return folder;
    }
    throw Error(Exit::storage,
                root_.string() + ": contains folders that are not part of a cache of remote files");
}

std::shared_ptr<CachedFile> CacheFolder::find(const std::string& url) const {
    const Descriptor locked = lock();
    const fs::path folder = folder_of(url);
    if (!ours(folder)) return {};
    auto file = CachedFile::open(folder);
    return file && file->origin().url == url ? file : nullptr;
}

std::shared_ptr<CachedFile> CacheFolder::find_or_make(const Origin& origin) const {
    const Descriptor locked = lock();
    const fs::path folder = folder_of(origin.url);
    if (ours(folder)) {
        auto file = CachedFile::open(folder);
        if (file && file->origin().url == origin.url && same_version(file->origin(), origin)) return file;
        file.reset();
        drop(folder);
    }
    std::error_code error;
    fs::create_directory(folder, error);
    if (error) throw Error(Exit::storage, folder.string() + ": cannot create: " + error.message());
    return CachedFile::create(folder, origin);
}

std::uint64_t CacheFolder::prune(std::uint64_t max_bytes) const {
    const Descriptor locked = lock();
    std::vector<Usage> all;
    std::error_code error;
    for (fs::directory_iterator entry(root_, error), end; !error && entry != end; entry.increment(error))
        if (named_like_ours(entry->path()) && ours(entry->path())) all.push_back(usage_of(entry->path()));
    std::ranges::sort(all, [](const Usage& a, const Usage& b) {
        return std::pair(a.used.tv_sec, a.used.tv_nsec) < std::pair(b.used.tv_sec, b.used.tv_nsec);
    });
    std::uint64_t total = 0;
    for (const Usage& usage : all) total += usage.bytes;
    for (const Usage& usage : all) {
        if (total <= max_bytes) break;
        if (!unused(usage.folder)) continue;
        drop(usage.folder);
        ::rmdir(usage.folder.c_str());
        total -= usage.bytes;
    }
    return total;
}

}  // namespace vantage
