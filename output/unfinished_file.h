#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// A file that is being written as FILE.part-PID: it takes its name when it is finished, and is removed
/// otherwise.
class UnfinishedFile {
  public:
    explicit UnfinishedFile(const std::filesystem::path& file);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    const std::filesystem::path& file() const { return file_; }
    /// Where it is to be written.
    const std::filesystem::path& part() const { return part_; }
    /// Throws Error(storage) if it cannot be renamed.
    void finish() const;
    /// Throws Error(storage): the file cannot be written, and why, unless that is empty.
    [[noreturn]] void fail(const std::string& why) const;

  private:
    std::filesystem::path file_, part_;
};

}  // namespace vantage
