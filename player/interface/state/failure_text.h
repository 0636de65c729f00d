#pragma once
#include <string>

#include "base/text/error.h"

namespace vantage {

/// An error message: a sentence in the window's language, and a reason if the kind of error has one. The next
/// line is the error itself, in English.
std::string failure_text(const std::string& sentence, const Error& error);
/// Returns such a message for an error in another program or thread.
std::string failure_text(const std::string& sentence, const std::string& error);

}  // namespace vantage
