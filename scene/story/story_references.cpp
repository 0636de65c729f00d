#include "scene/story/story_references.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

namespace vantage {
namespace {

std::string at(const char* list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

void check_stops(const Story& story, const std::vector<StoryStop>& stops, const std::string& place,
                 std::vector<std::string>& out) {
    for (std::size_t i = 0; i < stops.size(); ++i) {
        if (view_of_stop(story, stops[i])) continue;
        const bool exists = note_of(story, stops[i].note) != nullptr;
        out.push_back(place + at("stops", i) + ".note: found \"" + stops[i].note + "\", expected " +
                      (exists ? "a note that has a view" : "the id of a note"));
    }
}

/// Whether a file has the signature of a PNG or JPEG file.
bool is_picture(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return false;
    char head[8] = {};
    std::ifstream(file, std::ios::binary).read(head, sizeof head);
    const std::string_view bytes(head, sizeof head);
    return bytes == std::string_view("\x89PNG\r\n\x1a\n", 8) || bytes.starts_with("\xff\xd8\xff");
}

}  // namespace

std::vector<std::string> dangling_references(const Story& story) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < story.tours.size(); ++i)
        check_stops(story, story.tours[i].stops, at("tours", i) + ".", out);
    if (!story.attract) return out;
    check_stops(story, story.attract->stops, "attract.", out);
    const std::string& tour = story.attract->tour;
    if (!tour.empty() && !std::ranges::count(story.tours, tour, &StoryTour::id))
        out.push_back("attract.tour: found \"" + tour + "\", expected the id of a tour");
    return out;
}

std::vector<std::string> missing_pictures(const Story& story, const std::filesystem::path& folder) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < story.notes.size(); ++i) {
        const std::string& picture = story.notes[i].picture;
        if (picture.empty() || is_picture(folder / picture)) continue;
        std::error_code error;
        const bool exists = std::filesystem::exists(folder / picture, error);
        out.push_back(at("notes", i) + ".picture: " + picture +
                      (exists ? " is not a PNG or JPEG file" : " does not exist"));
    }
    return out;
}

std::vector<std::string> anchors_outside(const Story& story, const Eigen::AlignedBox3d& box) {
    constexpr double margin = 0.1;  // fraction of the diagonal
    std::vector<std::string> out;
    for (std::size_t i = 0; i < story.notes.size(); ++i) {
        const auto& anchor = story.notes[i].anchor;
        if (!anchor || !(box.exteriorDistance(*anchor) > margin * box.diagonal().norm())) continue;
        std::ostringstream line;
        line << at("notes", i) << ".anchor: is " << box.exteriorDistance(*anchor)
             << " outside the model, expected a point on it";
        out.push_back(line.str());
    }
    return out;
}

}  // namespace vantage
