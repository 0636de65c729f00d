#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/agree/registration.h"

namespace vantage {

/// Photos that do not show what the others show through the model, a line each; where two of them fit with
/// each other's cameras, that is said. Throws Error(damaged).
std::vector<std::string> misplaced_photos(const RegistrationInput& input,
                                          std::span<const package::PairRecord> pairs);

}  // namespace vantage
