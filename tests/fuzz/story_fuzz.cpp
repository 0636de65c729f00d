// Stories. Checks that accepted numbers are finite, that references can be checked, and that a story is
// unchanged after writing and reading.
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/text/error.h"
#include "scene/story/story_file.h"
#include "scene/story/story_references.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

namespace {

void check_view(const StoryView& v) {
    if (!v.eye.allFinite() || !v.target.allFinite() || !((v.target - v.eye).norm() > 0)) std::abort();
    if ((v.up && !v.up->allFinite()) || !std::isfinite(v.roll) || !(v.fov > 0 && v.fov < 179)) std::abort();
}

void check_stops(const std::vector<StoryStop>& stops) {
    for (const StoryStop& s : stops) {
        if (s.view) check_view(*s.view);
        if (s.view.has_value() == !s.note.empty() || !(s.fly >= 0) || !(s.stay >= 0)) std::abort();
    }
}

void check_story(const Story& story) {
    if (story.opening) check_view(*story.opening);
    for (const StoryNote& n : story.notes) {
        if (n.view) check_view(*n.view);
        const auto picture = std::filesystem::path(n.picture).lexically_normal();
        if (n.anchor && !n.anchor->allFinite()) std::abort();
        if (picture.is_absolute() || (!picture.empty() && *picture.begin() == "..")) std::abort();
    }
    for (const StoryTour& t : story.tours) check_stops(t.stops);
    if (story.attract) check_stops(story.attract->stops);
    for (const std::string& language : languages_of(story)) text_in(story, story.title, language);
    dangling_references(story);
    anchors_outside(story, Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()));
}

std::optional<ReadStory> accepted(const std::string& text) {
    try {
        return parse_story(text, "fuzz.story.json");
    } catch (const Error& e) {
        if (std::string_view(e.what()).find('\n') != std::string_view::npos) std::abort();
        return {};
    }
}

}  // namespace

FUZZ_TARGET(story)(const std::uint8_t* data, std::size_t size) {
    const auto read = accepted(std::string(fuzz::text_of(data, size)));
    if (!read) return 0;
    check_story(read->story);
    const std::string text = story_text(read->story);
    const auto again = accepted(text);
    if (!again || again->story != read->story || story_text(again->story) != text) std::abort();
    return 0;
}
