#pragma once
#include <string>
#include <vector>

#include "tests/openxr/calls/handles.h"

namespace test_runtime {

/// The context that the program passes with a session, which must be current and support at least OpenGL 4.5.
GraphicsContext checked_context(const Instance& instance, const XrSessionCreateInfo& info);

bool is_current(const GraphicsContext& graphics);

/// Records a violation if the session's context is not current or has an error. Returns whether the context
/// is usable.
bool check_graphics(const Session& session);

/// Leaves an OpenGL error if the scenario requires it.
void be_careless();

bool is_depth(int64_t format);

/// Makes immutable textures, cleared to magenta so that undrawn areas are visible.
std::vector<uint32_t> make_textures(const XrSwapchainCreateInfo& info, std::size_t count);
void delete_textures(const std::vector<uint32_t>& textures);

/// The texels of a rectangle as stored, bottom row first.
std::vector<uint8_t> colors_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer);
std::vector<float> depths_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer);

}  // namespace test_runtime
