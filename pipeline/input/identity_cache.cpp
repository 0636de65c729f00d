#include "pipeline/input/identity_cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>

#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 16u << 20;  ///< of the cache, some 150 000 files: then it begins anew
constexpr std::time_t settled_after = 2;          ///< s: coarsest clock of a file system in use (FAT)

bool stat_of(const fs::path& file, struct stat& st) { return ::stat(file.c_str(), &st) == 0; }

/// All that changes when a file does. Empty where there is none.
std::string stamp(const fs::path& file) {
    struct stat st {};
    if (!stat_of(file, st)) return {};
    return fmt::format("{:x}:{:x}:{:x}:{:x}.{:x}:{:x}.{:x}", st.st_dev, st.st_ino, st.st_size,
                       st.st_mtim.tv_sec, st.st_mtim.tv_nsec, st.st_ctim.tv_sec, st.st_ctim.tv_nsec);
}

/// A file touched this moment may be touched again without its times telling.
bool settled(const fs::path& file) {
    struct stat st {};
    return stat_of(file, st) &&
           std::max(st.st_mtim.tv_sec, st.st_ctim.tv_sec) + settled_after < std::time(nullptr);
}

}  // namespace

fs::path usual_identity_cache() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if (cache && *cache) return fs::path(cache) / "vantage" / "identities";
    if (home && *home) return fs::path(home) / ".cache" / "vantage" / "identities";
    return {};
}

IdentityCache::IdentityCache(fs::path cache, bool rehash) : cache_(std::move(cache)), rehash_(rehash) {
    std::ifstream in(cache_);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string mark;
        FileIdentity id;
        if (words >> mark >> id.bytes >> std::hex >> id.checksum) known_[mark] = id;
    }
}

/// One write of whole lines at the end: several programs may do so at once.
IdentityCache::~IdentityCache() {
    if (cache_.empty() || learned_.empty()) return;
    std::string lines;
    for (const auto& [mark, id] : learned_) lines += fmt::format("{} {} {:x}\n", mark, id.bytes, id.checksum);
    std::error_code error;
    fs::create_directories(cache_.parent_path(), error);
    const auto size = fs::file_size(cache_, error);
    const int start = !error && size > most_bytes ? O_TRUNC : O_APPEND;
    const int fd = ::open(cache_.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC | start, 0644);
    if (fd < 0) return;
    if (::write(fd, lines.data(), lines.size()) < 0) {
        // Only a hint.
    }
    ::close(fd);
}

std::optional<FileIdentity> IdentityCache::known(const fs::path& file) const {
    const std::string mark = stamp(file);
    const std::scoped_lock lock(mutex_);
    if (const auto it = learned_.find(mark); it != learned_.end()) return it->second;
    if (rehash_) return {};
    const auto it = known_.find(mark);
    return it == known_.end() ? std::nullopt : std::optional(it->second);
}

void IdentityCache::learn(const fs::path& file, const std::string& before, FileIdentity id) {
    if (before.empty() || !settled(file) || stamp(file) != before) return;
    const std::scoped_lock lock(mutex_);
    learned_[before] = id;
}

FileIdentity IdentityCache::of(const fs::path& file) {
    if (const auto id = known(file)) return *id;
    return read(file).second;
}

std::pair<std::vector<std::byte>, FileIdentity> IdentityCache::read(const fs::path& file) {
    const std::string before = stamp(file);
    std::vector<std::byte> bytes = read_file(file);
    const FileIdentity id = identify(bytes);
    learn(file, before, id);
    return {std::move(bytes), id};
}

FileIdentity stencil_identity(const PhotoInput& photo, IdentityCache& identities) {
    return photo.stencil.empty() ? FileIdentity{} : identities.of(photo.stencil);
}

}  // namespace vantage
