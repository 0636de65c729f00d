#include "player/window/remembered.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/files/replace_file.h"
#include "base/files/xdg_folder.h"
#include "base/text/is_url.h"
#include "base/text/json_text.h"

namespace vantage {
namespace {

/// Calls `field(name, value)` for each saved number and flag.
template <class R, class Field>
void for_fields(R& r, const Field& field) {
    auto& s = r.settings;
    auto& w = s.weights;
    field("width", r.window.width);
    field("height", r.window.height);
    field("text_scale", r.text_scale);
    field("language", r.language);
    field("transients", s.transients);
    field("refined_colors", s.refined_colors);
    field("photos", s.photos);
    field("angle_limit", s.angle_limit);
    field("fill_holes", s.fill_holes);
    field("distance", w.distance);
    field("angle", w.angle);
    field("angle_per_photo", w.angle_per_photo);
    field("angle_weight", w.angle_weight);
    field("depth_weight", w.depth_weight);
    field("border_weight", w.border_weight);
    field("transient_mask", w.transient_mask);
    field("corrected_directions", w.corrected_directions);
    field("exponent", w.exponent);
    field("sharpness", w.sharpness);
    field("expert", r.panels.expert);
    field("panel_photos", r.panels.photos);
    field("panel_frusta", r.panels.frusta);
    field("panel_radar", r.panels.radar);
    field("more_picture", r.panels.picture);
    field("more_photos", r.panels.photo_list);
    field("more_blending", r.panels.blending);
    field("more_fields", r.panels.fields);
    field("more_points", r.panels.points);
    field("more_image_sets", r.panels.image_sets);
    field("more_objects", r.panels.objects);
    field("more_surveying", r.panels.surveying);
    field("more_movement", r.panels.movement);
    field("more_status", r.panels.status);
    field("image_set", r.image_set);
    field("other_image_set", r.other_image_set);
    field("recent", r.recent);
    field("image_set_share", s.image_sets.share);
    field("image_set_swipe", s.image_sets.swipe);
}

/// Calls `choice(name, value)` for each saved choice.
template <class R, class Choice>
void for_choices(R& r, const Choice& choice) {
    choice("blend", r.settings.blend);
    choice("choice", r.settings.choice);
    choice("background", r.settings.background);
    choice("image_set_how", r.settings.image_sets.how);
    choice("transparency", r.settings.transparency);
}

/// Reads a field if the file contains it with the right type.
template <class T>
void read(const nlohmann::json& j, const char* name, T& value) {
    const auto it = j.find(name);
    if (it == j.end()) return;
    if constexpr (std::is_same_v<T, std::vector<std::string>>) {
        value.clear();
        for (const auto& text : *it)
            if (text.is_string()) value.push_back(text);
    } else if (std::is_same_v<T, std::string> ? it->is_string()
               : std::is_same_v<T, bool>      ? it->is_boolean()
               : std::is_integral_v<T>        ? it->is_number_integer()
                                              : it->is_number())
        value = it->get<T>();
}

template <class Enum>
void read_enum(const nlohmann::json& j, const char* name, Enum& value) {
    int number = -1;
    read(j, name, number);
    if (number >= 0 && number < int(Enum::count)) value = Enum(number);
}

nlohmann::json saved_settings(const std::filesystem::path& folder) {
    std::ifstream in(folder / "player.json");
    return json_of(std::string(std::istreambuf_iterator<char>(in), {}));
}

void write_json(const std::filesystem::path& folder, const nlohmann::json& settings) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    replace_file(folder / "player.json", json_text(settings) + '\n');
}

}  // namespace

std::filesystem::path settings_folder() { return xdg_folder("XDG_CONFIG_HOME", ".config"); }

Remembered read_settings(const std::filesystem::path& folder, Remembered r) {
    const nlohmann::json j = saved_settings(folder);
    if (!j.is_object()) return r;
    for_fields(r, [&](const char* name, auto& value) { read(j, name, value); });
    for_choices(r, [&](const char* name, auto& value) { read_enum(j, name, value); });
    // The file may have been edited, so values are clamped to valid ranges.
    r.window.width = std::clamp(r.window.width, 320, 16384);
    r.window.height = std::clamp(r.window.height, 240, 16384);
    if (r.text_scale != 0) r.text_scale = std::clamp(r.text_scale, 0.7, 4.0);
    r.settings.photos = std::clamp(r.settings.photos, 0, 1 << 20);
    r.settings.image_sets.share = std::clamp(r.settings.image_sets.share, 0.0, 1.0);
    r.settings.image_sets.swipe = std::clamp(r.settings.image_sets.swipe, 0.0, 1.0);
    r.settings.angle_limit = std::clamp(r.settings.angle_limit, 10.0, 180.0);
    r.settings.weights.sharpness = std::clamp(r.settings.weights.sharpness, 0.005, 3.0);
    r.settings.weights.exponent = std::clamp(r.settings.weights.exponent, 0.0, 64.0);
    return r;
}

void remember_opened(const std::filesystem::path& folder, const std::string& file) {
    constexpr std::size_t most = 8;
    std::error_code error;
    const std::string path = is_url(file) ? file : std::filesystem::absolute(file, error).string();
    if (folder.empty() || path.empty()) return;
    nlohmann::json j = saved_settings(folder);
    if (!j.is_object()) j = nlohmann::json::object();
    std::vector<std::string> files;
    read(j, "recent", files);
    std::erase(files, path);
    files.insert(files.begin(), path);
    if (files.size() > most) files.resize(most);
    j["recent"] = files;
    write_json(folder, j);
}

void write_settings(const std::filesystem::path& folder, const Remembered& r) {
    if (folder.empty()) return;
    nlohmann::json j;
    for_fields(r, [&](const char* name, const auto& value) { j[name] = value; });
    for_choices(r, [&](const char* name, const auto& value) { j[name] = int(value); });
    write_json(folder, j);
}

}  // namespace vantage
