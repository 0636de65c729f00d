#pragma once
#include <string>

namespace vantage {

/// What is said to the user, in a line or two.
struct Message {
    std::string text;    ///< empty: nothing
    double until = 0;    ///< seconds, at least
    bool shown = false;  ///< else its time begins when it is
};

inline constexpr double message_seconds = 6;
/// Shows a message for that time.
void say(Message& message, const std::string& text, double now);

}  // namespace vantage
