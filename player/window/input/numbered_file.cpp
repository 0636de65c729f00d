#include "player/window/input/numbered_file.h"

#include <filesystem>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "player/interface/state/failure_text.h"

namespace vantage {

std::string free_name(const std::string& stem, const char* extension) {
    for (int n = 1;; ++n) {
        const std::string name = stem + formatted("-%04d", n) + extension;
        std::error_code unknown;
        if (!std::filesystem::exists(name, unknown)) return name;
    }
}

std::string written_numbered(const std::string& stem, const char* extension, const WrittenTexts& texts,
                             const std::function<void(const std::string& file)>& write) {
    const std::string file = free_name(stem, extension);
    try {
        write(file);
        return formatted(texts.done.c_str(), texts.what.c_str(), file.c_str());
    } catch (const Error& e) {
        return failure_text(formatted(texts.failed.c_str(), file.c_str()), std::string(e.what()));
    }
}

void write_numbered(Message& message, const std::string& stem, const char* extension, const std::string& what,
                    double now, const std::function<void(const std::string& file)>& write) {
    say(message, written_numbered(stem, extension, {what}, write), now);
}

}  // namespace vantage
