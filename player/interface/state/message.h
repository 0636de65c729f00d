#pragma once
#include <string>

namespace vantage {

/// A message to the user, one or two lines long.
struct Message {
    std::string text;    ///< empty: nothing
    double until = 0;    ///< earliest end, seconds
    bool shown = false;  ///< false: its time starts when it is first shown
};

inline constexpr double message_seconds = 6;
/// Shows a message for its minimum time.
void say(Message& message, const std::string& text, double now);

}  // namespace vantage
