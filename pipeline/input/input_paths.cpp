#include "pipeline/input/input_paths.h"

#include "base/text/lower_extension.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/image_set_groups.h"
#include "pipeline/input/masks.h"
#include "pipeline/input/photo_matches.h"
#include "pipeline/run/files_below.h"

namespace vantage {

namespace fs = std::filesystem;

std::vector<fs::path> input_paths(const InputFiles& files) {
    std::vector<fs::path> out;
    if (!files.cameras.empty()) out = camera_files(files.cameras);
    for (const fs::path& more : files.more_cameras)
        for (fs::path& file : camera_files(more)) out.push_back(std::move(file));
    if (is_image_sets_file(files.image_sets)) out.emplace_back(files.image_sets);
    if (!files.mesh.empty()) out.push_back(files.mesh);
    out.insert(out.end(), files.compared.begin(), files.compared.end());
    out.insert(out.end(), files.points.begin(), files.points.end());
    if (files.mesh.has_parent_path() && fs::is_directory(files.mesh.parent_path()))
        for (const fs::path& file : files_below(files.mesh.parent_path(), 1))
            if (const std::string kind = lower_extension(file); kind == ".mtl" || kind == ".bin")
                out.push_back(file);
    if (!fs::is_directory(files.photos)) return out;  // read_scene will report it
    // Cameras may name photos in subfolders.
    Masks masks;
    for (const fs::path& file : files_below(files.photos, 2)) {
        if (!is_photo(file)) continue;
        out.push_back(file);
        if (fs::path mask = masks.of(file); !mask.empty()) out.push_back(std::move(mask));
    }
    return out;
}

}  // namespace vantage
