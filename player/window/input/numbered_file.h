#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "base/text/translation.h"
#include "player/interface/state/message.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The description of a file to write, and the messages in the language of the window.
struct WrittenTexts {
    std::string what;
    std::string done = tr("%s written to %s"), failed = tr("%s cannot be written.");
};

/// A message, and the file that was written; no file if that failed.
struct WrittenFile {
    std::string text;
    std::filesystem::path file{};
};

/// The path of new files about a package NAME.vantage, without their numbers and extensions: NAME and
/// `suffix` in the package's folder if it is writable. Otherwise in the user's folder of pictures if the
/// files are `pictures` and it is writable, or else in the current folder.
std::filesystem::path stem_for_files(const PackageReader& package, const char* suffix = "",
                                     bool pictures = false);

/// Writes to the file free_name(stem, extension); `extension` includes the dot. Returns `done` with WHAT and
/// FILE in place of its two %s, or `failed` with FILE and the reason from the Error that `write` threw.
/// Thread-safe.
WrittenFile written_numbered(const std::filesystem::path& stem, const char* extension,
                             const WrittenTexts& texts,
                             const std::function<void(const std::string& file)>& write);
/// Like written_numbered(), but shows the message "WHAT written to FILE".
void write_numbered(Message& message, const std::filesystem::path& stem, const char* extension,
                    const std::string& what, double now,
                    const std::function<void(const std::string& file)>& write);

/// The first of STEM-0001.EXT, STEM-0002.EXT, ... that does not exist.
std::string free_name(const std::filesystem::path& stem, const char* extension);

}  // namespace vantage
