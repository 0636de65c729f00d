#pragma once
#include <string>

#include "base/text/error.h"

namespace vantage {

/// An error message in the window's language: a sentence, and a reason if the kind of error has one. The next
/// line is the error itself, in English.
std::string failure_text(const std::string& sentence, const Error& error);
/// The same for an error of another program or thread.
std::string failure_text(const std::string& sentence, const std::string& error);

}  // namespace vantage
