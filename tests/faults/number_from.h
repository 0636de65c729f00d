#pragma once
#include <cstdlib>

namespace vantage {

/// The number in an environment variable; `usual` if the variable is not set.
inline int number_from(const char* variable, int usual) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : usual;
}

}  // namespace vantage
