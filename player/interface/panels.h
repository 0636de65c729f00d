#pragma once
#include "player/interface/controls.h"
#include "player/interface/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Sets ImGui's colors and shapes, and its font to DejaVu Sans if installed.
void set_style();

void menu_bar(Controls& controls, Session& session, const Renderer& renderer, double now);
void blending_panel(Controls& controls, Session& session, const Renderer& renderer);
/// `graphics_budget`: of all objects, bytes.
void status_panel(Session& session, const Renderer& renderer, std::uint64_t graphics_budget);
void help_panel(Session& session);
/// The session's message, if there is one.
void message_line(const Session& session, double now);

}  // namespace vantage
