#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/agree/registration.h"

namespace vantage {

/// Warnings about photos that contradict the others, one line per photo; two photos that match their
/// neighbors with each other's cameras share a line. Throws Error(damaged).
std::vector<std::string> misplaced_photos(const RegistrationInput& input,
                                          std::span<const package::PairRecord> pairs);

}  // namespace vantage
