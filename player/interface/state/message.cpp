#include "player/interface/state/message.h"

namespace vantage {

double seconds_of(const Message& message) { return message.file.empty() ? 6 : 12; }

void say(Message& message, const std::string& text, double now, const std::filesystem::path& file) {
    message = {text, now, false, file};
    message.until += seconds_of(message);
}

}  // namespace vantage
