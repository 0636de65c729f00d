#include "player/window/own_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "scene/error.h"

extern char** environ;

namespace vantage {

OwnProgram::OwnProgram(std::vector<std::string> arguments)
    : errors_(::memfd_create("messages", MFD_CLOEXEC)) {
    arguments.insert(arguments.begin(), "vantage-player");
    std::vector<char*> argv;
    for (std::string& word : arguments) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, errors_.get(), STDERR_FILENO);
    const int error = ::posix_spawn(&process_, "/proc/self/exe", &files, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (error == 0) return;
    process_ = -1;
    throw Error(Exit::input, std::string("vantage-player cannot be started: ") + std::strerror(error));
}

std::optional<OwnProgram::Ended> OwnProgram::ended() {
    int status = 0;
    if (process_ < 0 || ::waitpid(process_, &status, WNOHANG) <= 0) return {};
    process_ = -1;
    return Ended{WIFEXITED(status) && WEXITSTATUS(status) == 0, first_error()};
}

std::string OwnProgram::first_error() const {
    std::array<char, 1024> bytes{};
    const ssize_t read = ::pread(errors_.get(), bytes.data(), bytes.size(), 0);
    const auto end = bytes.begin() + std::max<ssize_t>(0, read);
    return std::string(bytes.begin(), std::find(bytes.begin(), end, '\n'));
}

}  // namespace vantage
