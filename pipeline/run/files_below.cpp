#include "pipeline/run/files_below.h"

#include <algorithm>
#include <string>

#include "base/text/error.h"

namespace vantage {

namespace fs = std::filesystem;

namespace {

/// `above`: the enclosing folders, which are not entered again.
void add_files(const fs::path& folder, int levels, std::vector<fs::path> above,
               std::vector<fs::path>& files) {
    std::error_code error;
    above.push_back(fs::canonical(folder, error));
    if (std::ranges::count(above, above.back()) > 1) return;  // a link to an enclosing folder
    fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
    if (error) throw Error(Exit::input, folder.string() + ": cannot list the folder: " + error.message());
    for (const fs::directory_entry& entry : it) {
        if (is_hidden(entry.path())) continue;
        if (entry.is_regular_file(error))
            files.push_back(entry.path());
        else if (levels > 0 && entry.is_directory(error))
            add_files(entry.path(), levels - 1, above, files);
    }
}

}  // namespace

bool is_hidden(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with(".") || name == "__MACOSX" || name == "@eaDir";
}

std::vector<fs::path> files_below(const fs::path& folder, int levels) {
    std::vector<fs::path> files;
    add_files(folder, levels, {}, files);
    std::ranges::sort(files);
    return files;
}

}  // namespace vantage
