#pragma once
#include <functional>
#include <string>

#include "base/text/translation.h"
#include "player/interface/state/message.h"

namespace vantage {

/// The description of a file to write, and the messages in the language of the window.
struct WrittenTexts {
    std::string what;
    std::string done = tr("%s written to %s"), failed = tr("%s cannot be written.");
};

/// Writes to the file free_name(stem, extension); `extension` includes the dot. Returns `done` with WHAT and
/// FILE in place of its two %s, or `failed` with FILE and the reason from the Error that `write` threw.
/// Thread-safe.
std::string written_numbered(const std::string& stem, const char* extension, const WrittenTexts& texts,
                             const std::function<void(const std::string& file)>& write);
/// Like written_numbered(), but shows the message "WHAT written to FILE".
void write_numbered(Message& message, const std::string& stem, const char* extension, const std::string& what,
                    double now, const std::function<void(const std::string& file)>& write);

/// The first name of STEM-0001.EXT, STEM-0002.EXT, ... that does not exist in the current folder.
std::string free_name(const std::string& stem, const char* extension);

}  // namespace vantage
