#include "scene/story/story_file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/is_url.h"
#include "base/text/located_json.h"
#include "base/text/lower_extension.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t max_bytes = std::size_t(8) << 20, max_notes = 1000, max_tours = 100, max_stops = 1000,
                      max_hidden = 10000, max_languages = 50, max_id = 100, max_title = 500, max_text = 20000,
                      max_path = 500;
constexpr int max_depth = 12;
constexpr double max_seconds = 3600, fov_low = 0.02, fov_high = 178;

std::string read_language(const LocatedJson& at, const std::string& tag) {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '-'; };
    if (tag.size() < 2 || tag.size() > 35 || !std::ranges::all_of(tag, allowed))
        at.fail("a language, such as \"en\" or \"pt-BR\"");
    return tag;
}

StoryText read_text(const LocatedJson& at, std::size_t most, bool lines) {
    StoryText out;
    if (at.is_object())
        for (const auto& [tag, words] : at.entries(max_languages))
            out.by_language[read_language(words, tag)] = words.text(most, lines);
    else if (at.is_text())
        out.plain = at.text(most, lines);
    else
        at.fail("a string, or an object with a string for each language");
    return out;
}

std::string read_id(const LocatedJson& at) {
    const std::string id = at.text(max_id);
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_' || c == '.'; };
    if (id.empty() || !std::ranges::all_of(id, allowed))
        at.fail("an id that consists of letters, digits, '-', '_' and '.'");
    return id;
}

StoryColor read_color(const LocatedJson& at) {
    const std::string text = at.text(max_id);
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    if (text.size() != 7 || text[0] != '#' || !std::all_of(text.begin() + 1, text.end(), is_digit))
        at.fail("a color, such as \"#20262e\"");
    StoryColor out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = std::uint8_t(std::stoul(text.substr(1 + 2 * c, 2), nullptr, 16));
    return out;
}

StoryView read_view(const LocatedJson& at) {
    at.expect_object({"eye", "target", "up", "roll", "fov"});
    StoryView out{at.at("eye").vector(), at.at("target").vector()};
    if (!((out.target - out.eye).norm() > 0)) at.fail("a target that differs from the eye");
    if (at.has("up")) {
        out.up = at.at("up").vector();
        if (!(out.up->norm() > 0)) at.at("up").fail("a direction other than 0, 0, 0");
    }
    if (at.has("roll")) out.roll = at.at("roll").number(-360, 360);
    if (at.has("fov")) out.fov = at.at("fov").number(fov_low, fov_high);
    return out;
}

std::string read_web(const LocatedJson& at) {
    const std::string text = at.text(max_path);
    if (!is_url(text) || text.find(' ') != std::string::npos)
        at.fail("an address that begins with https:// or http://");
    return text;
}

std::string read_picture(const LocatedJson& at) {
    const fs::path picture = at.text(max_path);
    const std::string extension = lower_extension(picture);
    if (picture.is_absolute() || is_url(picture.native()) ||
        std::ranges::find(picture, fs::path("..")) != picture.end())
        at.fail("a file below the story's folder");
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg")
        at.fail("the name of a PNG or JPEG file");
    return picture.string();
}

StoryNote read_note(const LocatedJson& at) {
    at.expect_object({"id", "title", "text", "picture", "view", "anchor"});
    StoryNote out;
    out.id = read_id(at.at("id"));
    if (at.has("title")) out.title = read_text(at.at("title"), max_title, false);
    if (at.has("text")) out.text = read_text(at.at("text"), max_text, true);
    if (at.has("picture")) out.picture = read_picture(at.at("picture"));
    if (at.has("view")) out.view = read_view(at.at("view"));
    if (at.has("anchor")) out.anchor = at.at("anchor").vector();
    return out;
}

std::vector<StoryStop> read_stops(const LocatedJson& at) {
    std::vector<StoryStop> out;
    for (const LocatedJson& stop : at.items(max_stops)) {
        stop.expect_object({"note", "view", "fly", "stay"});
        if (stop.has("note") == stop.has("view")) stop.fail("either a note or a view");
        StoryStop& s = out.emplace_back();
        if (stop.has("note")) s.note = read_id(stop.at("note"));
        if (stop.has("view")) s.view = read_view(stop.at("view"));
        if (stop.has("fly")) s.fly = stop.at("fly").number(0, max_seconds);
        if (stop.has("stay")) s.stay = stop.at("stay").number(0, max_seconds);
    }
    if (out.empty()) at.fail("at least one stop");
    return out;
}

StoryTour read_tour(const LocatedJson& at) {
    at.expect_object({"id", "title", "stops"});
    StoryTour out{read_id(at.at("id")), {}, read_stops(at.at("stops"))};
    if (at.has("title")) out.title = read_text(at.at("title"), max_title, false);
    return out;
}

StoryBackground read_background(const LocatedJson& at) {
    at.expect_object({"color", "top", "bottom", "soft_edges"});
    StoryBackground out;
    const bool gradient = at.has("top") && at.has("bottom");
    if (at.has("color") == gradient || at.has("top") != at.has("bottom"))
        at.fail("either color, or top and bottom");
    out.top = read_color(at.at(gradient ? "top" : "color"));
    out.bottom = gradient ? read_color(at.at("bottom")) : out.top;
    if (at.has("soft_edges")) out.soft_edges = at.at("soft_edges").number(0, 0.5);
    return out;
}

StoryLimits read_limits(const LocatedJson& at) {
    at.expect_object({"near_photos", "farthest"});
    StoryLimits out;
    if (at.has("near_photos")) out.near_photos = at.at("near_photos").boolean();
    if (at.has("farthest")) out.farthest = at.at("farthest").number(1e-6, 1e12);
    return out;
}

std::vector<StoryBall> read_hidden(const LocatedJson& at) {
    std::vector<StoryBall> out;
    for (const LocatedJson& ball : at.items(max_hidden)) {
        ball.expect_object({"center", "radius"});
        out.push_back({ball.at("center").vector(), ball.at("radius").number(1e-12, 1e12)});
    }
    return out;
}

StoryAttract read_attract(const LocatedJson& at) {
    at.expect_object({"after", "tour", "stops", "turn"});
    StoryAttract out;
    if (int(at.has("tour")) + int(at.has("stops")) + int(at.has("turn")) != 1)
        at.fail("one of tour, stops and turn");
    if (at.has("after")) out.after = at.at("after").number(1, 24 * max_seconds);
    if (at.has("tour")) out.tour = read_id(at.at("tour"));
    if (at.has("stops")) out.stops = read_stops(at.at("stops"));
    if (at.has("turn")) out.turn = at.at("turn").number(1, max_seconds);
    return out;
}

/// Expects all items to have different IDs.
template <class Item>
void expect_different(const std::vector<Item>& items, const LocatedJson& at) {
    std::set<std::string> ids;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (!ids.insert(items[i].id).second) at.items(items.size())[i].at("id").fail("a unique id");
}

Story read_top(const LocatedJson& at) {
    at.expect_object({"format", "language", "title", "web", "opening", "background", "only_object", "limits",
                      "hidden", "notes", "tours", "attract"});
    if (at.at("format").text(max_title) != story_format)
        at.at("format").fail('"' + std::string(story_format) + '"');
    Story out;
    if (at.has("language")) out.language = read_language(at.at("language"), at.at("language").text(max_id));
    if (at.has("title")) out.title = read_text(at.at("title"), max_title, false);
    if (at.has("web")) out.web = read_web(at.at("web"));
    if (at.has("opening")) out.opening = read_view(at.at("opening"));
    if (at.has("background")) out.background = read_background(at.at("background"));
    if (at.has("only_object")) out.only_object = at.at("only_object").boolean();
    if (at.has("limits")) out.limits = read_limits(at.at("limits"));
    if (at.has("hidden")) out.hidden = read_hidden(at.at("hidden"));
    if (at.has("notes")) {
        for (const LocatedJson& note : at.at("notes").items(max_notes)) out.notes.push_back(read_note(note));
        expect_different(out.notes, at.at("notes"));
    }
    if (at.has("tours")) {
        for (const LocatedJson& tour : at.at("tours").items(max_tours)) out.tours.push_back(read_tour(tour));
        expect_different(out.tours, at.at("tours"));
    }
    if (at.has("attract")) out.attract = read_attract(at.at("attract"));
    return out;
}

ordered_json json_of(const StoryText& text) {
    if (text.by_language.empty()) return text.plain;
    ordered_json out = ordered_json::object();
    for (const auto& [tag, words] : text.by_language) out[tag] = words;
    return out;
}

ordered_json json_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json json_of(const StoryView& view) {
    ordered_json out{{"eye", json_of(view.eye)}, {"target", json_of(view.target)}};
    if (view.up) out["up"] = json_of(*view.up);
    if (view.roll != 0) out["roll"] = view.roll;
    out["fov"] = view.fov;
    return out;
}

ordered_json json_of(const StoryNote& note) {
    ordered_json out{{"id", note.id}};
    if (!note.title.empty()) out["title"] = json_of(note.title);
    if (!note.text.empty()) out["text"] = json_of(note.text);
    if (!note.picture.empty()) out["picture"] = note.picture;
    if (note.view) out["view"] = json_of(*note.view);
    if (note.anchor) out["anchor"] = json_of(*note.anchor);
    return out;
}

ordered_json json_of(const std::vector<StoryStop>& stops) {
    ordered_json out = ordered_json::array();
    for (const StoryStop& s : stops) {
        ordered_json stop;
        if (s.view)
            stop["view"] = json_of(*s.view);
        else
            stop["note"] = s.note;
        stop["fly"] = s.fly;
        stop["stay"] = s.stay;
        out.push_back(stop);
    }
    return out;
}

std::string text_of(const StoryColor& c) { return formatted("#%02x%02x%02x", c[0], c[1], c[2]); }

ordered_json json_of(const StoryBackground& b) {
    ordered_json out;
    if (b.top == b.bottom)
        out["color"] = text_of(b.top);
    else
        out = {{"top", text_of(b.top)}, {"bottom", text_of(b.bottom)}};
    if (b.soft_edges != 0) out["soft_edges"] = b.soft_edges;
    return out;
}

ordered_json json_of(const StoryLimits& limits) {
    ordered_json out;
    if (!limits.near_photos) out["near_photos"] = false;
    if (limits.farthest) out["farthest"] = *limits.farthest;
    return out;
}

ordered_json json_of(const StoryAttract& a) {
    ordered_json out{{"after", a.after}};
    if (!a.tour.empty())
        out["tour"] = a.tour;
    else if (!a.stops.empty())
        out["stops"] = json_of(a.stops);
    else
        out["turn"] = a.turn;
    return out;
}

ordered_json json_of(const Story& story) {
    ordered_json out{{"format", story_format}, {"language", story.language}};
    if (!story.title.empty()) out["title"] = json_of(story.title);
    if (!story.web.empty()) out["web"] = story.web;
    if (story.opening) out["opening"] = json_of(*story.opening);
    if (story.background) out["background"] = json_of(*story.background);
    if (story.only_object) out["only_object"] = true;
    if (story.limits != StoryLimits{}) out["limits"] = json_of(story.limits);
    for (const StoryBall& ball : story.hidden)
        out["hidden"].push_back({{"center", json_of(ball.center)}, {"radius", ball.radius}});
    if (!story.notes.empty()) out["notes"] = ordered_json::array();
    for (const StoryNote& note : story.notes) out["notes"].push_back(json_of(note));
    if (!story.tours.empty()) out["tours"] = ordered_json::array();
    for (const StoryTour& tour : story.tours) {
        ordered_json t{{"id", tour.id}};
        if (!tour.title.empty()) t["title"] = json_of(tour.title);
        t["stops"] = json_of(tour.stops);
        out["tours"].push_back(t);
    }
    if (story.attract) out["attract"] = json_of(*story.attract);
    return out;
}

/// Prints arrays of numbers on one line, and everything else on separate lines.
void print(std::ostream& out, const ordered_json& value, const std::string& indent) {
    const bool object = value.is_object();
    if (!value.is_structured() || value.empty() || (!object && value.front().is_number())) {
        const char* between = "";
        if (value.is_array()) {
            out << '[';
            for (const ordered_json& item : value) out << std::exchange(between, ", ") << item.dump();
            out << ']';
        } else {
            out << value.dump();
        }
        return;
    }
    out << (object ? "{" : "[");
    const char* before = "\n";
    for (const auto& [key, item] : value.items()) {
        out << std::exchange(before, ",\n") << indent << "  ";
        if (object) out << ordered_json(key).dump() << ": ";
        print(out, item, indent + "  ");
    }
    out << '\n' << indent << (object ? "}" : "]");
}

}  // namespace

fs::path story_file_of(const fs::path& package) {
    if (package.empty() || is_url(package.native())) return {};
    return fs::path(package).replace_extension(".story.json");
}

ReadStory parse_story(const std::string& text, const std::string& file) {
    ReadStory out;
    const nlohmann::json json = parsed_json(text, file, max_depth);
    out.story = read_top(LocatedJson(file, json, out.unknown));
    return out;
}

ReadStory read_story(const fs::path& file) {
    std::error_code error;
    std::ifstream in(file, std::ios::binary);
    if (!fs::is_regular_file(file, error) || !in)
        throw Error(Exit::input, file.string() + ": cannot be read");
    if (fs::file_size(file, error) > max_bytes)
        throw Error(Exit::input, file.string() + ": is longer than 8 MiB, expected a story");
    std::ostringstream text;
    text << in.rdbuf();
    return parse_story(std::move(text).str(), file.string());
}

std::string story_text(const Story& story) {
    std::ostringstream out;
    print(out, json_of(story), "");
    out << '\n';
    return std::move(out).str();
}

void write_story(const fs::path& file, const Story& story) {
    std::string text;
    try {
        text = story_text(story);
        if (parse_story(text, "story").story != story)
            throw Error(Exit::input, "changes when it is read back");
    } catch (const std::exception& e) {  // including texts that are not UTF-8
        throw Error(Exit::usage, file.string() + ": cannot be saved: " + e.what());
    }
    replace_file(file, text);
}

}  // namespace vantage
