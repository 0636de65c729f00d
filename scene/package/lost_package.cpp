#include "scene/package/lost_package.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

#include "base/text/error.h"

namespace vantage {
namespace {

/// A signal handler reads this, so there are no locks and no allocation. Mappings beyond this number are not
/// tracked.
struct Mapped {
    std::atomic<const std::byte*> first = nullptr;
    std::atomic<std::size_t> size = 0;
    std::atomic<const char*> path = nullptr;
};
std::array<Mapped, 16> mapped;
const char* program_name = "";
std::atomic_flag reported;  // several threads may read beyond the end at once

void print(const char* text) {
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // stderr is closed
}

void on_bus_error(int signal, siginfo_t* info, void*) {
    const auto* at = static_cast<const std::byte*>(info->si_addr);
    for (const Mapped& m : mapped) {
        const std::byte* first = m.first;
        if (!first || at < first || at >= first + m.size) continue;
        while (reported.test_and_set()) ::pause();
        for (const char* text : {program_name, ": ", static_cast<const char*>(m.path),
                                 ": can no longer be read: it was truncated, or its disk is gone\n"})
            print(text);
        ::_exit(int(Exit::damaged));
    }
    // The address is not in a package: returning raises the signal again, which ends the process.
    ::signal(signal, SIG_DFL);
}

}  // namespace

void name_lost_packages(const char* program) {
    program_name = program;
    struct sigaction action {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO;
    ::sigaction(SIGBUS, &action, nullptr);
}

void announce_mapping(std::span<const std::byte> bytes, const char* path) {
    for (Mapped& m : mapped) {
        const char* none = nullptr;
        if (!m.path.compare_exchange_strong(none, path)) continue;
        m.size = bytes.size();
        m.first = bytes.data();
        return;
    }
}

void withdraw_mapping(std::span<const std::byte> bytes) {
    for (Mapped& m : mapped) {
        if (m.first != bytes.data()) continue;
        m.first = nullptr;
        m.path = nullptr;
        return;
    }
}

}  // namespace vantage
