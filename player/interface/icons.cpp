#include "player/interface/icons.h"

#include <cmath>
#include <numbers>

namespace vantage {
namespace {

/// Draws in coordinates from -1 to 1.
struct Pen {
    ImDrawList& list;
    ImVec2 middle;
    float half;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {middle.x + half * x, middle.y + half * y}; }
    float width() const { return half * 0.18f; }
    void line(float x0, float y0, float x1, float y1) const {
        list.AddLine(at(x0, y0), at(x1, y1), color, width());
    }
    void box(float x0, float y0, float x1, float y1) const {
        list.AddRect(at(x0, y0), at(x1, y1), color, half * 0.15f, 0, width());
    }
    void fill(float x0, float y0, float x1, float y1) const {
        list.AddRectFilled(at(x0, y0), at(x1, y1), color);
    }
    void disk(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), radius * half, color); }
};

void home(const Pen& p) {
    p.list.AddTriangleFilled(p.at(0, -0.95f), p.at(0.95f, 0), p.at(-0.95f, 0), p.color);
    p.fill(-0.62f, 0, -0.2f, 0.85f);
    p.fill(0.2f, 0, 0.62f, 0.85f);
    p.fill(-0.62f, 0, 0.62f, 0.3f);
}

void photos(const Pen& p) {
    p.box(-0.9f, -0.45f, 0.55f, 0.75f);
    p.line(-0.55f, -0.8f, 0.9f, -0.8f);
    p.line(0.9f, -0.8f, 0.9f, 0.4f);
    p.list.AddTriangleFilled(p.at(-0.75f, 0.6f), p.at(-0.25f, -0.1f), p.at(0.3f, 0.6f), p.color);
}

void compare(const Pen& p) {
    p.box(-0.9f, -0.65f, 0.9f, 0.65f);
    p.fill(-0.9f, -0.65f, 0, 0.65f);
    p.line(0, -0.95f, 0, 0.95f);
}

void light(const Pen& p) {
    p.disk(0, 0, 0.42f);
    for (int i = 0; i < 8; ++i) {
        const float angle = float(i) * std::numbers::pi_v<float> / 4, x = std::cos(angle),
                    y = std::sin(angle);
        p.line(0.62f * x, 0.62f * y, 0.95f * x, 0.95f * y);
    }
}

/// A cube.
void object(const Pen& p) {
    const ImVec2 outline[] = {p.at(0, -0.95f), p.at(0.82f, -0.48f), p.at(0.82f, 0.48f),
                              p.at(0, 0.95f),  p.at(-0.82f, 0.48f), p.at(-0.82f, -0.48f)};
    p.list.AddPolyline(outline, 6, p.color, ImDrawFlags_Closed, p.width());
    p.line(0, 0, 0, 0.95f);
    p.line(0, 0, 0.82f, -0.48f);
    p.line(0, 0, -0.82f, -0.48f);
}

/// Three places that are connected.
void share(const Pen& p) {
    p.line(-0.6f, 0, 0.6f, -0.62f);
    p.line(-0.6f, 0, 0.6f, 0.62f);
    p.disk(-0.6f, 0, 0.3f);
    p.disk(0.6f, -0.62f, 0.3f);
    p.disk(0.6f, 0.62f, 0.3f);
}

/// A globe.
void language(const Pen& p) {
    const auto ring = [&](float across) {
        constexpr int points = 24;
        ImVec2 at[points];
        for (int i = 0; i < points; ++i) {
            const float angle = 2 * std::numbers::pi_v<float> * float(i) / points;
            at[i] = p.at(across * std::cos(angle), 0.9f * std::sin(angle));
        }
        p.list.AddPolyline(at, points, p.color, ImDrawFlags_Closed, p.width());
    };
    ring(0.9f);
    ring(0.4f);
    p.line(-0.9f, 0, 0.9f, 0);
}

void full_screen(const Pen& p) {
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
            p.line(0.85f * x, 0.75f * y, 0.85f * x, 0.25f * y);
            p.line(0.85f * x, 0.75f * y, 0.35f * x, 0.75f * y);
        }
}

void help(const Pen& p) {
    p.list.AddCircle(p.middle, 0.9f * p.half, p.color, 0, p.width());
    const float size = 1.35f * p.half;
    const ImVec2 text = ImGui::GetFont()->CalcTextSizeA(size, 1e9f, 0, "?");
    p.list.AddText(ImGui::GetFont(), size, ImVec2(p.middle.x - text.x / 2, p.middle.y - text.y / 2), p.color,
                   "?");
}

void expert(const Pen& p) {
    constexpr float knobs[] = {-0.35f, 0.4f, -0.1f};
    for (int i = 0; i < 3; ++i) {
        const float y = 0.62f * float(i - 1);
        p.line(-0.9f, y, 0.9f, y);
        p.disk(knobs[i], y, 0.26f);
    }
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 color) {
    const Pen pen{list, middle, size / 2, color};
    switch (icon) {
        case Icon::home:
            return home(pen);
        case Icon::photos:
            return photos(pen);
        case Icon::compare:
            return compare(pen);
        case Icon::light:
            return light(pen);
        case Icon::object:
            return object(pen);
        case Icon::share:
            return share(pen);
        case Icon::language:
            return language(pen);
        case Icon::full_screen:
            return full_screen(pen);
        case Icon::help:
            return help(pen);
        case Icon::expert:
            return expert(pen);
    }
}

}  // namespace vantage
