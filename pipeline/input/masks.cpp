#include "pipeline/input/masks.h"

#include "base/text/file_name.h"

namespace vantage {

namespace fs = std::filesystem;

fs::path Masks::of(const fs::path& photo) {
    const fs::path folder = photo.parent_path(), above = folder.parent_path();
    const fs::path beside = find(above, "masks"), higher = find(above.parent_path(), "masks");
    const fs::path in_higher = higher.empty() ? fs::path() : find(higher, folder.filename().string());
    for (const std::string& name : {photo.filename().string(), photo.stem().string()}) {
        fs::path found = find(folder, name + ".mask.png");
        for (const fs::path& masks : {in_higher, beside})
            if (found.empty() && !masks.empty()) found = find(masks, name + ".png");
        if (std::error_code error; fs::is_regular_file(found, error)) return found;
    }
    return {};
}

/// The file or folder itself if it exists, otherwise one with the same comparable_name().
fs::path Masks::find(const fs::path& folder, const std::string& name) {
    std::error_code error;
    const auto [listed, is_new] = folders_.try_emplace(folder);
    if (is_new)
        for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
            listed->second.emplace(comparable_name(entry.path().filename().string()), entry.path());
    const auto found = listed->second.find(comparable_name(name));
    if (found == listed->second.end()) return {};
    const fs::path exact = folder / name;
    return fs::exists(exact, error) ? exact : found->second;
}

}  // namespace vantage
