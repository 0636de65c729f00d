#pragma once
#include <functional>
#include <string>

#include "player/interface/session.h"

namespace vantage {

/// Writes the first of STEM-0001.EXT, STEM-0002.EXT, ... that does not exist into the current folder;
/// `extension` with its dot. Says "WHAT written to FILE", or why `write` threw an Error.
void write_numbered(Session& session, const std::string& stem, const char* extension, const std::string& what,
                    double now, const std::function<void(const std::string& file)>& write);

/// Writes a text file. Throws Error(storage).
void write_text(const std::string& file, const std::string& text);

}  // namespace vantage
