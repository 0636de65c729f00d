#include "player/interface/state/failure_text.h"

#include "base/text/translation.h"

namespace vantage {
namespace {

const char* reason(Exit code) {
    switch (code) {
        case Exit::input:
            return tr("A file is missing, cannot be read, or is unsuitable.");
        case Exit::damaged:
            return tr("The file is damaged, or has the wrong type.");
        case Exit::storage:
            return tr("The disk is full, or access is denied.");
        case Exit::memory:
            return tr("There is not enough memory.");
        default:
            return "";
    }
}

}  // namespace

std::string failure_text(const std::string& sentence, const Error& error) {
    const std::string why = reason(error.code());
    return failure_text(sentence + (why.empty() ? "" : " ") + why, std::string(error.what()));
}

std::string failure_text(const std::string& sentence, const std::string& error) {
    return sentence + "\n" + error;
}

}  // namespace vantage
