#include "pipeline/formats/meshes/isolated_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

/// This process's private writable memory in bytes, which RLIMIT_DATA limits.
std::uint64_t writable_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t pages[6]{};
    for (std::uint64_t& p : pages) statm >> p;
    return pages[5] * std::uint64_t(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::uint64_t max) {
    const rlimit r{max, max};
    ::setrlimit(resource, &r);
}

[[noreturn]] void run_child(const ProcessLimits& limits, const std::string& out,
                            const std::function<std::vector<std::byte>()>& work) {
    const int null = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
    for (const int crash : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) ::signal(crash, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, limits.seconds);
    limit(RLIMIT_DATA, writable_bytes() + limits.bytes);
    try {
        const std::vector<std::byte> bytes = work();
        std::ofstream file(out, std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        ::_exit(file.flush() ? 0 : 1);
    } catch (...) {
        ::_exit(1);
    }
}

}  // namespace

std::vector<std::byte> run_isolated(const ProcessLimits& limits,
                                    const std::function<std::vector<std::byte>()>& work) {
    const int memory = ::memfd_create("vantage", MFD_CLOEXEC);
    if (memory < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
    const std::string out = "/proc/self/fd/" + std::to_string(memory);
    const pid_t child = ::fork();
    if (child == 0) run_child(limits, out, work);
    if (child < 0) {
        ::close(memory);
        throw std::system_error(errno, std::generic_category(), "fork");
    }
    int status = 1;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    std::vector<std::byte> bytes;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) bytes = read_file(out);
    ::close(memory);
    return bytes;
}

}  // namespace vantage
