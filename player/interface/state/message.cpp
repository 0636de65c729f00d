#include "player/interface/state/message.h"

namespace vantage {

void say(Message& message, const std::string& text, double now) {
    message = {text, now + message_seconds, false};
}

}  // namespace vantage
