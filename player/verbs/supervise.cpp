#include "player/verbs/supervise.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>

#include "base/files/xdg_folder.h"
#include "base/text/error.h"

namespace vantage {
namespace {

constexpr int silent_ms = 60'000;
volatile std::sig_atomic_t told_to_end = 0;
volatile pid_t player = 0;

void end(int) {
    told_to_end = 1;
    if (player > 0) ::kill(player, SIGTERM);
}

void note(const std::filesystem::path& log, const std::string& what) {
    char time[32];
    const std::time_t now = std::time(nullptr);
    std::strftime(time, sizeof time, "%F %T", std::localtime(&now));
    std::FILE* out = log.empty() ? stderr : std::fopen(log.c_str(), "a");
    if (!out) out = stderr;
    std::fprintf(out, "%s  %s\n", time, what.c_str());
    if (out != stderr) std::fclose(out);
}

struct Run {
    int code = 0;  ///< exit code, or 128 plus the terminating signal
    bool showed = false, hung = false;
};

/// Waits until the player ends, and terminates it if it is unresponsive.
Run watch(pid_t child, int heartbeat_fd) {
    Run out;
    for (pollfd p{heartbeat_fd, POLLIN, 0};;) {
        const int ready = ::poll(&p, 1, silent_ms);
        if (ready < 0 && errno == EINTR) continue;
        char bytes[256];
        if (ready > 0 && ::read(heartbeat_fd, bytes, sizeof bytes) > 0) {
            out.showed = true;
            continue;
        }
        if (ready == 0) {
            out.hung = true;
            ::kill(child, SIGKILL);
        }
        break;  // the player has closed its end of the pipe
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return out;
}

Run run_once(const std::function<int(int heartbeat_fd)>& run) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw Error(Exit::internal,
                    std::string("cannot create a pipe to the player: ") + std::strerror(errno));
    const pid_t child = ::fork();
    if (child < 0)
        throw Error(Exit::internal,
                    std::string("cannot start a process for the player: ") + std::strerror(errno));
    if (child == 0) {
        std::signal(SIGTERM, SIG_DFL);
        std::signal(SIGINT, SIG_DFL);
        ::close(ends[0]);
        ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
        std::exit(run(ends[1]));
    }
    player = child;
    ::close(ends[1]);
    const Run out = watch(child, ends[0]);
    player = 0;
    ::close(ends[0]);
    return out;
}

}  // namespace

int supervise(const std::function<int(int heartbeat_fd)>& run, const std::filesystem::path& log) {
    std::error_code ignored;
    if (!log.empty()) std::filesystem::create_directories(log.parent_path(), ignored);
    std::signal(SIGTERM, end);
    std::signal(SIGINT, end);
    note(log, "started");
    bool showed = false;
    for (auto pause = std::chrono::seconds(1);; pause = std::min(2 * pause, std::chrono::seconds(60))) {
        const Run r = run_once(run);
        if (told_to_end) return note(log, "ended by SIGTERM or SIGINT"), 0;
        showed |= r.showed;
        note(log, r.hung          ? "unresponsive for a minute; restarted"
                  : r.code >= 128 ? "ended by signal " + std::to_string(r.code - 128) + ": restarted"
                                  : "ended with exit code " + std::to_string(r.code) + ": restarted");
        const Exit code = Exit(r.code);
        if (!showed && (code == Exit::usage || code == Exit::input || code == Exit::damaged)) return r.code;
        if (r.showed) pause = std::chrono::seconds(1);
        std::this_thread::sleep_for(pause);
        if (told_to_end) return note(log, "ended by SIGTERM or SIGINT"), 0;
    }
}

std::filesystem::path kiosk_log() {
    const std::filesystem::path folder = xdg_folder("XDG_STATE_HOME", ".local/state");
    return folder.empty() ? folder : folder / "kiosk.log";
}

}  // namespace vantage
