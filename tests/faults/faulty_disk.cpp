// Simulates disk failures in a program that preloads this library, as specified by FAULT="CALL:N:HOW".
// CALL is pwrite, fallocate, fsync, rename, flock or statvfs, or "any" for all operations on files below
// FAULT_FOLDER.
// HOW is one of:
// - ENOSPC, EIO or EACCES: the N-th call and all later ones fail; statvfs reports no free space instead.
// - EIO_ONCE: only the N-th call fails.
// - SHORT_ONCE: the N-th call reads or writes only half of its bytes.
// - KILL or KILL_AFTER: the process is killed before or after the N-th call is executed.
// - WAIT: the N-th call waits until the file FAULT_CONTINUE exists (flock only).
// - BAD_PAGE: the N-th page of mapped files cannot be read; touching it raises SIGBUS (mmap only).
// FAULT_CLOCK=1 moves the clock forward and back by a year on alternate calls.
// FAULT_LOG=FILE records all operations that change files below FAULT_FOLDER (tests/faults/disk_log.h).
// FAULT_COUNT=FILE receives the number of calls (or mapped pages) at exit.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Fault {
    char call[16] = "", how[16] = "";
    int from = 0, calls = 0;
    std::string folder;
    int log = -1;
    std::mutex mutex;  ///< guards `calls`; held while an operation is executed and recorded

    Fault() {
        if (const char* text = std::getenv("FAULT")) std::sscanf(text, "%15[^:]:%d:%15s", call, &from, how);
        if (const char* text = std::getenv("FAULT_FOLDER")) folder = std::string(text) + "/";
        if (const char* text = std::getenv("FAULT_LOG"))
            log = int(::syscall(SYS_openat, AT_FDCWD, text, O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0644));
    }
    ~Fault() {
        if (const char* file = std::getenv("FAULT_COUNT"))
            if (FILE* out = std::fopen(file, "w")) std::fprintf(out, "%d\n", calls), std::fclose(out);
    }
    bool is(const char* name) const { return std::strcmp(how, name) == 0; }
    int error() const { return is("ENOSPC") ? ENOSPC : is("EACCES") ? EACCES : EIO; }
    bool holds(const std::string& path) const {
        return !folder.empty() && (path.starts_with(folder) || path + "/" == folder);
    }
};

Fault& fault() {
    static Fault f;
    return f;
}

constexpr std::size_t page_bytes = 4096;

/// Counts the pages of a file mapping that are not holes. If the page that should fail is among them,
/// replaces it with a page beyond the end of a file.
void spoil_page(void* mapping, std::size_t size, int fd) {
    Fault& f = fault();
    off_t end = 0;
    for (off_t at = ::lseek(fd, 0, SEEK_DATA); at >= 0 && at < off_t(size);
         at = ::lseek(fd, end, SEEK_DATA)) {
        end = std::min(::lseek(fd, at, SEEK_HOLE), off_t(size));
        if (end <= at) break;
        const off_t first = at / off_t(page_bytes);
        const int pages = int((end + off_t(page_bytes) - 1) / off_t(page_bytes) - first),
                  page = f.from - 1 - f.calls;
        f.calls += pages;
        if (page < 0 || page >= pages) continue;
        const int empty = int(::syscall(SYS_memfd_create, "empty", 0u));
        ::syscall(SYS_mmap, static_cast<char*>(mapping) + std::size_t(first + page) * page_bytes, page_bytes,
                  PROT_READ, MAP_SHARED | MAP_FIXED, empty, 0l);
        ::syscall(SYS_close, empty);
    }
}

enum class Fate { real, fails, is_short };

/// Counts a call on the file at `path` and returns the call's fate. Kills the process if FAULT says to kill
/// it before this call.
Fate fate_of(const char* name, const std::string& path, bool& killed_after) {
    Fault& f = fault();
    if (f.is("BAD_PAGE")) return Fate::real;
    const bool any = std::strcmp(f.call, "any") == 0;
    if (any ? !f.holds(path) : std::strcmp(f.call, name) != 0) return Fate::real;
    const int n = ++f.calls;
    if (n == f.from && f.is("KILL")) ::kill(::getpid(), SIGKILL);
    killed_after = n == f.from && f.is("KILL_AFTER");
    if (f.is("KILL") || f.is("KILL_AFTER")) return Fate::real;
    if (f.is("SHORT_ONCE")) return n == f.from ? Fate::is_short : Fate::real;
    if (f.is("EIO_ONCE")) return n == f.from ? Fate::fails : Fate::real;
    return n >= f.from ? Fate::fails : Fate::real;
}

/// The return value of a failed call: -1, or null for calls that return pointers.
template <class T>
T failed() {
    if constexpr (std::is_pointer_v<T>)
        return nullptr;
    else
        return -1;
}

/// Returns the result of the real call or simulates its failure. `real` receives the number of bytes (0 if
/// the call transfers none), and `record` receives the result of a successful call.
template <class Real, class Record>
auto perform(const char* name, const std::string& path, std::size_t bytes, Real real, Record record)
    -> decltype(real(bytes)) {
    Fault& f = fault();
    const std::scoped_lock lock(f.mutex);
    bool killed_after = false;
    const Fate fate = fate_of(name, path, killed_after);
    if (fate == Fate::fails) {
        errno = f.error();
        return failed<decltype(real(bytes))>();
    }
    const auto result = real(fate == Fate::is_short ? (bytes + 1) / 2 : bytes);
    if (f.log >= 0 && f.holds(path) && result != failed<decltype(real(bytes))>()) record(result);
    if (killed_after) ::kill(::getpid(), SIGKILL);
    return result;
}
template <class Real>
auto perform(const char* name, const std::string& path, std::size_t bytes, Real real)
    -> decltype(real(bytes)) {
    return perform(name, path, bytes, real, [](const auto&) {});
}

template <class F>
F* next(const char* name) {
    return reinterpret_cast<F*>(::dlsym(RTLD_NEXT, name));
}

std::string path_of(int fd) {
    if (fault().folder.empty()) return {};
    char path[4096];
    const ssize_t n = ::readlink(("/proc/self/fd/" + std::to_string(fd)).c_str(), path, sizeof path);
    return n > 0 ? std::string(path, std::size_t(n)) : std::string();
}

/// Writes one record: the kind, the offset, and the sizes of the path, the second path and the data, followed
/// by these three strings.
void record(char kind, const std::string& path, std::uint64_t offset = 0, std::string_view data = {},
            const std::string& other = {}) {
    const std::uint64_t numbers[] = {std::uint64_t(kind), offset, path.size(), other.size(), data.size()};
    std::string all(reinterpret_cast<const char*>(numbers), sizeof numbers);
    all.append(path).append(other).append(data);
    for (std::string_view rest = all; !rest.empty();)
        rest.remove_prefix(
            std::size_t(std::max(0l, ::syscall(SYS_write, fault().log, rest.data(), rest.size()))));
}

void record_size(const std::string& path, std::uint64_t size) { record('s', path, size); }

std::uint64_t size_of(int fd) {
    struct stat st {};
    return ::fstat(fd, &st) == 0 ? std::uint64_t(st.st_size) : 0;
}

/// Records bytes that are already in a file.
void record_content(int fd, const std::string& path, std::uint64_t offset, std::size_t size) {
    std::string data(size, '\0');
    const long n = ::syscall(SYS_pread64, fd, data.data(), size, off64_t(offset));
    record('w', path, offset, std::string_view(data).substr(0, std::size_t(std::max(0l, n))));
}

std::string_view text(const void* data, ssize_t size) {
    return {static_cast<const char*>(data), std::size_t(size)};
}

int open_file(const char* path, int flags, mode_t mode) {
    struct stat st {};
    const bool existed = ::stat(path, &st) == 0;
    return perform(
        "open", path, 0,
        [&](std::size_t) { return next<int(const char*, int, ...)>("open")(path, flags, mode); },
        [&](int) {
            if (flags & O_CREAT && !existed) record('c', path);
            if (flags & O_TRUNC) record_size(path, 0);
        });
}

/// Records data that write() has just written. The data ends at the file's current position.
void record_written(int fd, const std::string& path, std::string_view data) {
    const long end = ::syscall(SYS_lseek, fd, 0, SEEK_CUR);
    record('w', path, std::uint64_t(end) - data.size(), data);
}

/// The simulated error of the clock at this call, in seconds.
time_t clock_error() {
    static const bool jumps = std::getenv("FAULT_CLOCK") != nullptr;
    static std::atomic<int> calls = 0;
    constexpr time_t year = 365 * 24 * 3600;
    return !jumps ? 0 : ++calls % 2 ? year : -year;
}

}  // namespace

// Where off_t has 64 bits, each function whose name ends in 64 is the same as the one without the suffix.
extern "C" {

int open(const char* path, int flags, ...) {
    std::va_list more;
    va_start(more, flags);
    const auto mode = flags & (O_CREAT | O_TMPFILE) ? mode_t(va_arg(more, int)) : mode_t(0);
    va_end(more);
    return open_file(path, flags, mode);
}
int open64(const char*, int, ...) __attribute__((alias("open")));
FILE* fopen(const char* path, const char* mode) {
    struct stat st {};
    const bool existed = ::stat(path, &st) == 0;
    return perform(
        "open", path, 0,
        [&](std::size_t) { return next<FILE*(const char*, const char*)>("fopen")(path, mode); },
        [&](FILE*) {
            if (*mode == 'w' && !existed) record('c', path);
            if (*mode == 'w') record_size(path, 0);
        });
}
FILE* fopen64(const char*, const char*) __attribute__((alias("fopen")));

ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
    const std::string path = path_of(fd);
    return perform(
        "pwrite", path, size,
        [&](std::size_t n) {
            return next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(fd, data, n, at);
        },
        [&](ssize_t n) { record('w', path, std::uint64_t(at), text(data, n)); });
}
ssize_t pwrite64(int, const void*, size_t, off64_t) __attribute__((alias("pwrite")));
ssize_t pread(int fd, void* data, size_t size, off_t at) {
    return perform("pread", path_of(fd), size, [&](std::size_t n) {
        return next<ssize_t(int, void*, size_t, off_t)>("pread")(fd, data, n, at);
    });
}
ssize_t pread64(int, void*, size_t, off64_t) __attribute__((alias("pread")));
ssize_t write(int fd, const void* data, size_t size) {
    const std::string path = path_of(fd);
    return perform(
        "write", path, size,
        [&](std::size_t n) { return next<ssize_t(int, const void*, size_t)>("write")(fd, data, n); },
        [&](ssize_t n) { record_written(fd, path, text(data, n)); });
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
    const std::string path = path_of(fd);
    return perform(
        "write", path, 0,
        [&](std::size_t) { return next<ssize_t(int, const struct iovec*, int)>("writev")(fd, parts, count); },
        [&](ssize_t n) {
            std::string data;
            for (int i = 0; i < count; ++i) data += text(parts[i].iov_base, ssize_t(parts[i].iov_len));
            record_written(fd, path, std::string_view(data).substr(0, std::size_t(n)));
        });
}
ssize_t read(int fd, void* data, size_t size) {
    return perform("read", path_of(fd), size,
                   [&](std::size_t n) { return next<ssize_t(int, void*, size_t)>("read")(fd, data, n); });
}
ssize_t copy_file_range(int from, off64_t* from_at, int to, off64_t* to_at, size_t size, unsigned flags) {
    const std::string path = path_of(to);
    const off64_t at = to_at ? *to_at : 0;
    return perform(
        "copy", path, size,
        [&](std::size_t n) {
            return next<ssize_t(int, off64_t*, int, off64_t*, size_t, unsigned)>("copy_file_range")(
                from, from_at, to, to_at, n, flags);
        },
        [&](ssize_t n) { record_content(to, path, std::uint64_t(at), std::size_t(n)); });
}
int ftruncate(int fd, off_t size) {
    const std::string path = path_of(fd);
    return perform(
        "ftruncate", path, 0, [&](std::size_t) { return next<int(int, off_t)>("ftruncate")(fd, size); },
        [&](int) { record_size(path, std::uint64_t(size)); });
}
int ftruncate64(int, off64_t) __attribute__((alias("ftruncate")));
int posix_fallocate(int fd, off_t from, off_t size) {
    const std::string path = path_of(fd);
    int error = 0;
    const int result = perform(
        "fallocate", path, 0,
        [&](std::size_t) {
            error = next<int(int, off_t, off_t)>("posix_fallocate")(fd, from, size);
            return error ? -1 : 0;
        },
        [&](int) { record_size(path, size_of(fd)); });
    return result == 0 ? 0 : error ? error : errno;
}
int posix_fallocate64(int, off64_t, off64_t) __attribute__((alias("posix_fallocate")));
int fallocate(int fd, int mode, off_t from, off_t size) {
    const std::string path = path_of(fd);
    return perform(
        "fallocate", path, 0,
        [&](std::size_t) { return next<int(int, int, off_t, off_t)>("fallocate")(fd, mode, from, size); },
        [&](int) { record_content(fd, path, std::uint64_t(from), std::size_t(size)); });
}
void* mmap(void* at, size_t size, int protection, int flags, int fd, off_t offset) {
    const auto real = [&](std::size_t) {
        return next<void*(void*, size_t, int, int, int, off_t)>("mmap")(at, size, protection, flags, fd,
                                                                        offset);
    };
    if (fd < 0) return real(0);
    if (Fault& f = fault(); f.is("BAD_PAGE")) {
        void* const mapped = real(0);
        const std::scoped_lock lock(f.mutex);
        if (mapped != MAP_FAILED && f.holds(path_of(fd))) spoil_page(mapped, size, fd);
        return mapped;
    }
    void* const mapped = perform("mmap", path_of(fd), 0, real);
    return mapped ? mapped : MAP_FAILED;
}
void* mmap64(void*, size_t, int, int, int, off64_t) __attribute__((alias("mmap")));
int statvfs(const char* path, struct statvfs* out) {
    const int result = next<int(const char*, struct statvfs*)>("statvfs")(path, out);
    if (perform("statvfs", {}, 0, [](std::size_t) { return 0; }) < 0) out->f_bavail = 0;  // no free space
    return result;
}
int flock(int fd, int operation) {
    Fault& f = fault();
    if (std::strcmp(f.call, "flock") == 0 && f.is("WAIT") && ++f.calls == f.from)
        while (::access(std::getenv("FAULT_CONTINUE"), F_OK) != 0) ::usleep(1000);
    return next<int(int, int)>("flock")(fd, operation);
}
int fsync(int fd) {
    const std::string path = path_of(fd);
    return perform(
        "fsync", path, 0, [&](std::size_t) { return next<int(int)>("fsync")(fd); },
        [&](int) { record('f', path); });
}
int rename(const char* from, const char* to) {
    return perform(
        "rename", from, 0,
        [&](std::size_t) { return next<int(const char*, const char*)>("rename")(from, to); },
        [&](int) { record('r', from, 0, {}, to); });
}
int unlink(const char* path) {
    return perform(
        "unlink", path, 0, [&](std::size_t) { return next<int(const char*)>("unlink")(path); },
        [&](int) { record('u', path); });
}
int remove(const char* path) {
    return perform(
        "unlink", path, 0, [&](std::size_t) { return next<int(const char*)>("remove")(path); },
        [&](int) { record('u', path); });
}

int clock_gettime(clockid_t clock, struct timespec* now) {
    const int result = int(::syscall(SYS_clock_gettime, clock, now));
    if (clock == CLOCK_REALTIME) now->tv_sec += clock_error();
    return result;
}
time_t time(time_t* out) {
    struct timespec now {};
    clock_gettime(CLOCK_REALTIME, &now);
    if (out) *out = now.tv_sec;
    return now.tv_sec;
}
}
