#include "player/window/input/numbered_file.h"

#include <unistd.h>

#include "base/files/xdg_folder.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "player/interface/state/failure_text.h"

namespace vantage {

std::filesystem::path stem_for_files(const PackageReader& package, const char* suffix, bool pictures) {
    std::error_code unknown;
    const auto writable = [](const std::filesystem::path& folder) {
        return !folder.empty() && ::access(folder.c_str(), W_OK) == 0;
    };
    std::filesystem::path folder = std::filesystem::absolute(package.path(), unknown).parent_path();
    if (package.remote() || !writable(folder)) folder = pictures ? pictures_folder() : "";
    if (!writable(folder)) folder = std::filesystem::current_path(unknown);
    return folder / (package.path().stem().string() + suffix);
}

std::string free_name(const std::filesystem::path& stem, const char* extension) {
    for (int n = 1;; ++n) {
        const std::string name = stem.string() + formatted("-%04d", n) + extension;
        std::error_code unknown;
        if (!std::filesystem::exists(name, unknown)) return name;
    }
}

WrittenFile written_numbered(const std::filesystem::path& stem, const char* extension,
                             const WrittenTexts& texts,
                             const std::function<void(const std::string& file)>& write) {
    const std::string file = free_name(stem, extension);
    try {
        write(file);
        return {formatted(texts.done.c_str(), texts.what.c_str(), file.c_str()), file};
    } catch (const Error& e) {
        return {failure_text(formatted(texts.failed.c_str(), file.c_str()), std::string(e.what()))};
    }
}

void write_numbered(Message& message, const std::filesystem::path& stem, const char* extension,
                    const std::string& what, double now,
                    const std::function<void(const std::string& file)>& write) {
    const WrittenFile written = written_numbered(stem, extension, {what}, write);
    say(message, written.text, now, written.file);
}

}  // namespace vantage
