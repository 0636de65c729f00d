#include "pipeline/input/identity_cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <ctime>
#include <fstream>
#include <utility>

#include "base/files/xdg_folder.h"
#include "base/text/error.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_cache_bytes = 16u << 20;  ///< about 150,000 files; a larger cache is emptied
/// In seconds: the resolution of the coarsest file system in use (FAT).
constexpr std::time_t timestamp_resolution = 2;

/// Prefix for the stamp of a package that was found valid.
const std::string valid_prefix = "valid:";

bool read_status(const fs::path& file, struct stat& st) { return ::stat(file.c_str(), &st) == 0; }

/// A line of the cache: the stamp, the bytes, and the checksum in hexadecimal.
std::optional<std::pair<std::string, FileIdentity>> parsed(const std::string& line) {
    const std::size_t stamp = line.find(' ');
    if (stamp == line.npos) return {};
    FileIdentity id;
    const char* const end = line.data() + line.size();
    const auto bytes = std::from_chars(line.data() + stamp + 1, end, id.bytes);
    if (bytes.ec != std::errc() || bytes.ptr == end || *bytes.ptr != ' ') return {};
    if (std::from_chars(bytes.ptr + 1, end, id.checksum, 16).ec != std::errc()) return {};
    return std::pair(line.substr(0, stamp), id);
}

/// Whether the next modification is certain to change the timestamps; one that immediately follows another
/// may not.
bool timestamps_are_reliable(const fs::path& file) {
    struct stat st {};
    return read_status(file, st) &&
           std::max(st.st_mtim.tv_sec, st.st_ctim.tv_sec) + timestamp_resolution < std::time(nullptr);
}

}  // namespace

fs::path default_identity_cache() {
    const fs::path folder = xdg_folder("XDG_CACHE_HOME", ".cache");
    return folder.empty() ? folder : folder / "identities";
}

IdentityCache::IdentityCache(fs::path cache, bool rehash) : cache_(std::move(cache)), rehash_(rehash) {
    std::ifstream in(cache_);
    for (std::string line; std::getline(in, line);)
        if (auto entry = parsed(line)) stored_.insert_or_assign(std::move(entry->first), entry->second);
}

// Writes whole lines with a single call, because several programs may append at the same time.
IdentityCache::~IdentityCache() {
    if (cache_.empty() || added_.empty()) return;
    std::string lines;
    for (const auto& [stamp, id] : added_) lines += fmt::format("{} {} {:x}\n", stamp, id.bytes, id.checksum);
    std::error_code error;
    fs::create_directories(cache_.parent_path(), error);
    const auto size = fs::file_size(cache_, error);
    const int mode = !error && size > max_cache_bytes ? O_TRUNC : O_APPEND;
    const int fd = ::open(cache_.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC | mode, 0644);
    if (fd < 0) return;
    if (::write(fd, lines.data(), lines.size()) < 0) {
        // A lost cache only costs time.
    }
    ::close(fd);
}

std::optional<FileIdentity> IdentityCache::known(const fs::path& file) const {
    const std::string stamp = stamp_of(file);
    const std::scoped_lock lock(mutex_);
    if (const auto it = added_.find(stamp); it != added_.end()) return it->second;
    if (rehash_) return {};
    const auto it = stored_.find(stamp);
    return it == stored_.end() ? std::nullopt : std::optional(it->second);
}

void IdentityCache::add(const fs::path& file, const std::string& stamp, FileIdentity id) {
    if (stamp.empty() || !timestamps_are_reliable(file) || stamp_of(file) != stamp) return;
    const std::scoped_lock lock(mutex_);
    added_[stamp] = id;
}

FileIdentity IdentityCache::of(const fs::path& file) {
    if (const auto id = known(file)) return *id;
    return read(file).second;
}

std::optional<FileIdentity> IdentityCache::try_of(const fs::path& file) {
    try {
        return of(file);
    } catch (const Error&) {
        return {};
    }
}

std::pair<std::vector<std::byte>, FileIdentity> IdentityCache::read(const fs::path& file) {
    const std::string stamp = stamp_of(file);
    std::vector<std::byte> bytes = read_file(file);
    const FileIdentity id = identify(bytes);
    add(file, stamp, id);
    return {std::move(bytes), id};
}

bool IdentityCache::known_valid(const std::string& stamp) const {
    const std::scoped_lock lock(mutex_);
    return added_.contains(valid_prefix + stamp) || (!rehash_ && stored_.contains(valid_prefix + stamp));
}

void IdentityCache::remember_valid(const fs::path& file, const std::string& stamp) {
    if (stamp.empty() || !timestamps_are_reliable(file) || stamp_of(file) != stamp) return;
    const std::scoped_lock lock(mutex_);
    added_[valid_prefix + stamp] = {};
}

FileIdentity mask_identity(const PhotoInput& photo, IdentityCache& identities) {
    return photo.mask.empty() ? FileIdentity{} : identities.of(photo.mask);
}

}  // namespace vantage
