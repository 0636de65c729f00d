#include "pipeline/input/input_paths.h"

#include "pipeline/formats/import/cameras.h"
#include "pipeline/input/discover.h"

namespace vantage {

namespace fs = std::filesystem;

std::vector<fs::path> input_paths(const InputFiles& files) {
    std::vector<fs::path> out = camera_files(files.cameras);
    out.push_back(files.mesh);
    std::error_code error;
    constexpr auto options = fs::directory_options::skip_permission_denied;
    // Cameras may name photos in subfolders.
    for (fs::recursive_directory_iterator it(files.photos, options, error), end; !error && it != end;
         it.increment(error)) {
        if (it.depth() >= 2) it.disable_recursion_pending();
        if (!is_photo(it->path())) continue;
        out.push_back(it->path());
        if (fs::path stencil = find_stencil(it->path()); !stencil.empty()) out.push_back(std::move(stencil));
    }
    return out;
}

}  // namespace vantage
