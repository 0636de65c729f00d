#include "pipeline/input/photo_matches.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include "base/text/file_name.h"
#include "base/text/lower_extension.h"
#include "pipeline/run/files_below.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// The extensions of photos, in order of preference for cameras whose file name has another extension.
constexpr const char* extensions[] = {".jpg", ".jpeg", ".png",  ".tif",  ".tiff", ".webp", ".bmp", ".jp2",
                                      ".ppm", ".heic", ".heif", ".avif", ".exr",  ".hdr",  ".dng", ".cr2",
                                      ".cr3", ".nef",  ".arw",  ".raf",  ".orf",  ".rw2",  ".pef", ".srw",
                                      ".nrw", ".rwl",  ".iiq",  ".3fr",  ".fff"};

std::size_t rank_of(const fs::path& file) {
    return std::size_t(std::ranges::find(extensions, lower_extension(file)) - std::begin(extensions));
}

bool has_photo_extension(const fs::path& file) { return rank_of(file) < std::size(extensions); }

/// The folders and the file name of a path as comparable names, the file name first.
std::vector<std::string> parts_from_the_end(const std::string& path) {
    const std::string comparable = comparable_name(path);
    std::vector<std::string> parts;
    for (const fs::path& part : fs::path(comparable))
        if (!part.empty() && part != "." && part != "/") parts.push_back(part.string());
    std::ranges::reverse(parts);
    return parts;
}

/// The name without its extension if this is an extension of photos, unlike the ".2" of "IMG_1.2".
std::string stem_of(const std::string& name) {
    return has_photo_extension(name) ? fs::path(name).stem().string() : name;
}

struct Photo {
    std::vector<std::string> parts;  ///< parts of the whole path
    std::size_t below = 0;           ///< number of parts below the photos' folder
};

/// The number of equal parts at the end of two paths whose file names are known to match.
std::size_t common_parts(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    std::size_t n = 1;
    while (n < a.size() && n < b.size() && a[n] == b[n]) ++n;
    return n;
}

class Matches {
  public:
    Matches(const fs::path& folder, const std::vector<fs::path>& photos,
            std::span<const CameraSet::Entry> cameras)
        : folder_(folder), files_(photos), cameras_(cameras) {
        for (const fs::path& file : photos) {
            const auto below = file.lexically_relative(folder);
            photos_.push_back({parts_from_the_end(fs::absolute(file).lexically_normal().string()),
                               std::size_t(std::distance(below.begin(), below.end()))});
            by_name_.emplace(photos_.back().parts.front(), photos_.size() - 1);
            by_stem_.emplace(stem_of(photos_.back().parts.front()), photos_.size() - 1);
        }
        for (const CameraSet::Entry& camera : cameras) {
            parts_.push_back(parts_from_the_end(camera.photo));
            in_group_.push_back(parts_.back());
            std::ranges::copy(parts_from_the_end(camera.group), std::back_inserter(in_group_.back()));
            if (!parts_.back().empty()) same_stem_[stem_of(parts_.back().front())].insert(parts_.back());
        }
    }
    PhotoMatch of(std::size_t camera) const {
        if (parts_[camera].empty()) return {};
        PhotoMatch out = best(camera, by_name_.equal_range(parts_[camera].front()));
        out.by_name = !out.file.empty();
        if (out.by_name || !out.candidates.empty()) return out;
        return best(camera, by_stem_.equal_range(stem_of(parts_[camera].front())));
    }

  private:
    using Index = std::multimap<std::string, std::size_t>;
    /// Whether the name may refer to this photo.
    bool fits(std::size_t name, const Photo& photo) const {
        const std::vector<std::string>& parts = parts_[name];
        const std::size_t common = common_parts(parts, photo.parts);
        if (common == parts.size()) return true;
        if (common < photo.below) return false;
        // The name has different folders, such as those of another machine: it must be the only name that
        // fits.
        return std::ranges::count_if(same_stem_.at(stem_of(parts.front())), [&](const auto& other) {
                   return common_parts(other, photo.parts) >= photo.below;
               }) == 1;
    }
    PhotoMatch best(std::size_t name, std::pair<Index::const_iterator, Index::const_iterator> range) const {
        const std::string& photo = cameras_[name].photo;
        // The criteria in order: number of equal folders, exact path, exact name, extension, depth.
        using Rank = std::tuple<std::size_t, bool, bool, std::size_t, std::size_t>;
        std::vector<std::pair<Rank, std::size_t>> found;
        for (const auto& [key, i] : std::ranges::subrange(range.first, range.second)) {
            if (!fits(name, photos_[i])) continue;
            const fs::path& file = files_[i];
            found.push_back(
                {Rank{common_parts(in_group_[name], photos_[i].parts), file == folder_ / photo,
                      file.filename() == fs::path(photo).filename(), std::size(extensions) - rank_of(file),
                      100 - std::min<std::size_t>(99, photos_[i].below)},
                 i});
        }
        if (found.empty()) return {};
        std::ranges::sort(found, std::greater{});
        PhotoMatch out;
        if (found.size() == 1 || found[0].first > found[1].first) {
            out.file = files_[found[0].second];
            out.folders = std::get<0>(found[0].first) - 1;
            return out;
        }
        for (const auto& [rank, i] : found)
            if (rank == found[0].first) out.candidates.push_back(files_[i]);
        std::ranges::sort(out.candidates);
        return out;
    }

    const fs::path& folder_;
    const std::vector<fs::path>& files_;
    std::span<const CameraSet::Entry> cameras_;
    std::vector<Photo> photos_;
    std::vector<std::vector<std::string>> parts_, in_group_;  ///< camera names, without and with groups
    Index by_name_, by_stem_;
    std::map<std::string, std::set<std::vector<std::string>>> same_stem_;
};

}  // namespace

bool is_photo(const fs::path& file) {
    return has_photo_extension(file) && !is_hidden(file) &&
           !comparable_name(file.filename().string()).ends_with(".mask.png");
}

bool is_derived(const fs::path& folder) {
    const std::string name = comparable_name(folder.filename().string());
    return std::ranges::any_of(
        std::initializer_list<const char*>{"mask", "masks", "weights", "depth", "depths", "depth_map",
                                           "depth_maps", "depthmaps", "normal", "normals", "normal_map",
                                           "normal_maps", "thumbnail", "thumbnails", "thumbs", "stereo",
                                           "segmentation", "semantics"},
        [&](const char* n) { return name == n; });
}

std::vector<fs::path> photos_below(const fs::path& folder) {
    std::vector<fs::path> photos = files_below(folder, 2);
    std::erase_if(photos, [&](const fs::path& file) {
        if (!is_photo(file)) return true;
        const fs::path below = file.lexically_relative(folder).parent_path();
        return std::ranges::any_of(below, is_derived);
    });
    return photos;
}

fs::path file_named(const fs::path& folder, const std::string& utf8) {
    fs::path path = folder;
    for (const fs::path& part : fs::path(utf8)) {
        std::error_code error;
        fs::path next = path / part;
        if (!fs::exists(next, error))
            if (const fs::path meant = file_meant(path, part.string()); !meant.empty()) next = meant;
        path = next;
    }
    return path;
}

std::string name_below(const fs::path& folder, const fs::path& file) {
    const fs::path below = file.lexically_relative(folder);
    return utf8_name(below.empty() || *below.begin() == ".." ? file.filename().string()
                                                             : below.generic_string());
}

fs::path file_meant(const fs::path& folder, const std::string& name) {
    const std::vector<fs::path> alike = files_called(folder, name);
    std::vector<fs::path> same;
    std::ranges::copy_if(alike, std::back_inserter(same),
                         [&](const fs::path& file) { return utf8_name(file.filename().string()) == name; });
    return same.size() == 1 ? same[0] : alike.size() == 1 ? alike[0] : fs::path();
}

std::vector<PhotoMatch> match_photos(const fs::path& folder, const std::vector<fs::path>& photos,
                                     std::span<const CameraSet::Entry> cameras) {
    const Matches matches(folder, photos, cameras);
    std::vector<PhotoMatch> out;
    std::set<fs::path> taken;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        out.push_back(matches.of(i));
        if (out.back().folders > 0) taken.insert(out.back().file);
    }
    for (PhotoMatch& m : out) {
        if (m.candidates.empty()) continue;
        const auto is_taken = [&](const fs::path& file) { return taken.contains(file); };
        if (std::ranges::count_if(m.candidates, std::not_fn(is_taken)) != 1) continue;
        m.file = *std::ranges::find_if_not(m.candidates, is_taken);
        m.candidates.clear();
    }
    return out;
}

std::vector<fs::path> unused_photos(const fs::path& folder, const std::vector<fs::path>& photos,
                                    const std::vector<fs::path>& used) {
    const auto bare = [](const fs::path& file) {
        return file.parent_path() / comparable_name(file.stem().string());
    };
    std::set<fs::path> folders{folder};
    std::map<fs::path, std::size_t> formats;  // ranks of the used photos' formats
    for (const fs::path& file : used) {
        folders.insert(file.parent_path());
        formats[bare(file)] = rank_of(file);
    }
    const std::set<fs::path> known(used.begin(), used.end());
    std::vector<fs::path> out;
    for (const fs::path& file : photos) {
        const auto beside = formats.find(bare(file));
        const bool other_format = beside != formats.end() && beside->second != rank_of(file);
        if (folders.contains(file.parent_path()) && !known.contains(file) && !other_format)
            out.push_back(file);
    }
    return out;
}

}  // namespace vantage
