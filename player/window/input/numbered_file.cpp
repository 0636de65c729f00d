#include "player/window/input/numbered_file.h"

#include <filesystem>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"

namespace vantage {

std::string free_name(const std::string& stem, const char* extension) {
    for (int n = 1;; ++n) {
        const std::string name = stem + formatted("-%04d", n) + extension;
        std::error_code unknown;
        if (!std::filesystem::exists(name, unknown)) return name;
    }
}

std::string written_numbered(const std::string& stem, const char* extension, const std::string& what,
                             const std::string& done,
                             const std::function<void(const std::string& file)>& write) {
    try {
        const std::string file = free_name(stem, extension);
        write(file);
        return formatted(done.c_str(), what.c_str(), file.c_str());
    } catch (const Error& e) {
        return e.what();
    }
}

void write_numbered(Message& message, const std::string& stem, const char* extension, const std::string& what,
                    double now, const std::function<void(const std::string& file)>& write) {
    say(message, written_numbered(stem, extension, what, tr("%s written to %s"), write), now);
}

}  // namespace vantage
