#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage::bench {

/// A folder of its own among the temporary files, gone with this. Throws Error(storage).
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Runs a program found on the PATH, no shell between, what it writes going to files. Its exit status; -1 if
/// a signal ended it, 127 if it is not to be found.
int run_program(const std::vector<std::string>& words, const std::filesystem::path& out,
                const std::filesystem::path& err);

}  // namespace vantage::bench
