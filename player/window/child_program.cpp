#include "player/window/child_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "base/text/error.h"

extern char** environ;

namespace vantage {
namespace {

std::string first_line(const Descriptor& file) {
    std::array<char, 4096> bytes{};
    const ssize_t read = ::pread(file.get(), bytes.data(), bytes.size(), 0);
    const auto end = bytes.begin() + std::max<ssize_t>(0, read);
    return std::string(bytes.begin(), std::find(bytes.begin(), end, '\n'));
}

}  // namespace

ChildProgram::ChildProgram(const std::string& program, std::vector<std::string> arguments)
    : output_(::memfd_create("output", MFD_CLOEXEC)), errors_(::memfd_create("errors", MFD_CLOEXEC)) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& word : arguments) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, output_.get(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, errors_.get(), STDERR_FILENO);
    const int error = ::posix_spawnp(&process_, program.c_str(), &files, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (error == 0) return;
    process_ = -1;
    throw Error(Exit::input, program + " cannot be started: " + std::strerror(error));
}

std::optional<ChildProgram::Ended> ChildProgram::ended() {
    int status = 0;
    if (process_ < 0 || ::waitpid(process_, &status, WNOHANG) <= 0) return {};
    process_ = -1;
    return Ended{WIFEXITED(status) && WEXITSTATUS(status) == 0, first_line(output_), first_line(errors_)};
}

}  // namespace vantage
