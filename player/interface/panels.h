#pragma once
#include "player/render/renderer.h"
#include "player/session.h"

namespace vantage {

/// Colours, roundness, and a font that can be read, where the system has it.
void set_style();

void menu_bar(Session& session, const Renderer& renderer, double now);
void blending_panel(Session& session, const Renderer& renderer);
void status_panel(const Session& session, const Renderer& renderer);
void help_panel(Session& session);
/// Asks for a package to open: those beside this one, or any by its name.
void open_dialog(Session& session, const Renderer& renderer);
/// The session's message, where there is one.
void message_line(const Session& session, double now);

}  // namespace vantage
