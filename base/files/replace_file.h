#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace vantage {

/// A file that is written in the same folder under a name that no other process or thread uses. The file is
/// renamed when it is finished, so that readers see either the old or the new content; an unfinished file is
/// removed.
class UnfinishedFile {
  public:
    /// Creates an empty file FILE.part-RANDOM with the permissions in `mode` that the umask does not remove.
    /// Throws Error(storage).
    explicit UnfinishedFile(const std::filesystem::path& file, unsigned mode = 0666);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    const std::filesystem::path& file() const { return file_; }
    /// The path to write to.
    const std::filesystem::path& part() const { return part_; }
    /// Renames the file. Throws Error(storage) if renaming fails.
    void finish() const;
    /// Throws Error(storage). The message says that the file cannot be written, followed by `why` unless that
    /// is empty.
    [[noreturn]] void fail(const std::string& why) const;

  private:
    std::filesystem::path file_, part_;
};

/// Suffix of an unfinished file's name, followed by random characters.
inline constexpr std::string_view unfinished_mark = ".part-";

/// Replaces a file atomically: after a crash or a power cut, the file has either the old or the new content.
/// On failure, throws Error(storage) and leaves the file unchanged.
void replace_file(const std::filesystem::path& file, std::string_view text, unsigned mode = 0666);
/// Replaces the file atomically with the output of `write`.
void replace_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write,
                  unsigned mode = 0666);

/// Renames a file, replacing any existing file with the new name. Throws Error(storage).
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace vantage
