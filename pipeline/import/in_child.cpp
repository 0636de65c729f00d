#include "pipeline/import/in_child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

namespace vantage {
namespace {

/// Bytes that the process could write to: what RLIMIT_DATA limits.
std::uint64_t writable_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t pages[6]{};
    for (std::uint64_t& p : pages) statm >> p;
    return pages[5] * std::uint64_t(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::uint64_t most) {
    const rlimit r{most, most};
    ::setrlimit(resource, &r);
}

bool write_all(int file, const std::vector<std::byte>& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t n = ::write(file, bytes.data() + at, bytes.size() - at);
        if (n <= 0) return false;
        at += std::size_t(n);
    }
    return true;
}

std::vector<std::byte> read_all(int file) {
    struct stat s {};
    if (::fstat(file, &s) != 0) return {};
    std::vector<std::byte> bytes(std::size_t(s.st_size));
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t n = ::pread(file, bytes.data() + at, bytes.size() - at, off_t(at));
        if (n <= 0) return {};
        at += std::size_t(n);
    }
    return bytes;
}

[[noreturn]] void be_the_child(const ChildLimits& limits, int out,
                               const std::function<std::vector<std::byte>()>& work) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
    for (const int crash : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) ::signal(crash, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, limits.seconds);
    limit(RLIMIT_DATA, writable_bytes() + limits.bytes);
    try {
        ::_exit(write_all(out, work()) ? 0 : 1);
    } catch (...) {
        ::_exit(1);
    }
}

}  // namespace

std::vector<std::byte> in_child(const ChildLimits& limits,
                                const std::function<std::vector<std::byte>()>& work) {
    const int out = ::memfd_create("vantage", MFD_CLOEXEC);
    if (out < 0) return {};
    const pid_t child = ::fork();
    if (child == 0) be_the_child(limits, out, work);
    int status = 1;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    std::vector<std::byte> bytes;
    if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) bytes = read_all(out);
    ::close(out);
    return bytes;
}

}  // namespace vantage
