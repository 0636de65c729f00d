#pragma once
#include <filesystem>
#include <string>

namespace vantage {

/// A message to the user, one or two lines long.
struct Message {
    std::string text;              ///< empty: nothing
    double until = 0;              ///< earliest end, seconds
    bool shown = false;            ///< false: its time starts when it is first shown
    std::filesystem::path file{};  ///< the file that was written, if any
};

/// The minimum time of a message, longer if it has buttons for a file.
double seconds_of(const Message& message);
/// Shows a message for its minimum time. `file`: the file that was written, if any.
void say(Message& message, const std::string& text, double now, const std::filesystem::path& file = {});

}  // namespace vantage
