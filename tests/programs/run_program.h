#pragma once
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace vantage {

struct Outcome {
    int code;  ///< exit code; -1 if killed by a signal
    std::string out, err;
};

/// Runs a shell command and redirects its output to files in a folder.
inline Outcome run_command(const std::string& command, const std::filesystem::path& folder) {
    const std::filesystem::path out = folder / "out.txt", err = folder / "err.txt";
    const int status = std::system((command + " >" + out.string() + " 2>" + err.string()).c_str());
    const auto text = [](const std::filesystem::path& file) {
        std::ostringstream bytes;
        bytes << std::ifstream(file, std::ios::binary).rdbuf();
        return bytes.str();
    };
    const bool exited = WIFEXITED(status) && WEXITSTATUS(status) < 128;
    return {exited ? WEXITSTATUS(status) : -1, text(out), text(err)};
}

/// Changes "VERB OPTIONS" to "VERB FILE OPTIONS".
inline std::string with_file(const std::string& words, const std::filesystem::path& file) {
    const bool verb = !words.starts_with('-');
    const std::size_t end = verb ? std::min(words.find(' '), words.size()) : 0;
    return words.substr(0, end) + " " + file.string() + " " + words.substr(end);
}

}  // namespace vantage
