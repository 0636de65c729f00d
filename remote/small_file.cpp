#include "remote/small_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include "remote/storage_error.h"
#include "values/descriptor.h"

namespace vantage {

std::string read_small_file(const std::filesystem::path& path) {
    constexpr std::size_t most_bytes = 64 << 10;
    const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    struct stat st {};
    if (!fd || ::fstat(fd.get(), &st) != 0 || !S_ISREG(st.st_mode)) return {};
    std::string content(most_bytes, '\0');
    const ssize_t n = ::pread(fd.get(), content.data(), content.size(), 0);
    content.resize(n < 0 ? 0 : std::size_t(n));
    return content;
}

void write_small_file(const std::filesystem::path& path, const std::string& content) {
    std::filesystem::path part = path;
    part += ".part";
    ::unlink(part.c_str());
    {
        const Descriptor fd(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
        if (!fd) throw storage_error(part, "create");
        const ssize_t n = ::write(fd.get(), content.data(), content.size());
        if (n >= 0 && std::size_t(n) != content.size()) errno = ENOSPC;
        if (n < 0 || std::size_t(n) != content.size() || ::fsync(fd.get()) != 0)
            throw storage_error(part, "write");
    }
    if (::rename(part.c_str(), path.c_str()) != 0) throw storage_error(path, "replace");
}

}  // namespace vantage
