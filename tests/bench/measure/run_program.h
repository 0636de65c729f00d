#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage::bench {

/// A temporary folder, removed by the destructor. Throws Error(storage).
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

/// Runs a program from the PATH without a shell, with its output redirected to files; `out` and `err` may be
/// the same. Returns its exit status, -1 if a signal ended it, 127 if it cannot be started.
int run_program(const std::vector<std::string>& words, const std::filesystem::path& out,
                const std::filesystem::path& err);

}  // namespace vantage::bench
