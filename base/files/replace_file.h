#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace vantage {

/// A file that is being written beside its place, under a name that no other process or thread uses. It takes
/// its name when it is finished, so that readers see the old content or the new one; it is removed otherwise.
class UnfinishedFile {
  public:
    /// Creates FILE.part-RANDOM, empty, with the permissions `mode` less the umask. Throws Error(storage).
    explicit UnfinishedFile(const std::filesystem::path& file, unsigned mode = 0666);
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

/// What the name of an unfinished file adds to that of the file, before its random end.
inline constexpr std::string_view unfinished_mark = ".part-";

/// Replaces a file at once: after a crash or a power cut there is the old content or the new one. Throws
/// Error(storage), and leaves the file as it was, if that is not possible.
void replace_file(const std::filesystem::path& file, std::string_view text, unsigned mode = 0666);
/// The same with what `write` writes.
void replace_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write,
                  unsigned mode = 0666);

/// Renames a file, replacing the one of the new name. Throws Error(storage).
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace vantage
