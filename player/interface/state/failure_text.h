#pragma once
#include <string>

#include "base/text/error.h"

namespace vantage {

/// What has failed, in the language of the window: a sentence, and a reason if the kind of error has one. On
/// the next line is the error itself, in English.
std::string failure_text(const std::string& sentence, const Error& error);
/// That of an error of another program or thread.
std::string failure_text(const std::string& sentence, const std::string& error);

}  // namespace vantage
