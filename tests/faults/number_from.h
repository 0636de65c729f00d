#pragma once
#include <cstdlib>

namespace vantage {

/// A number from the environment.
inline int number_from(const char* variable, int usual) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : usual;
}

}  // namespace vantage
