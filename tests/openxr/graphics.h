#pragma once
#include <string>
#include <vector>

#include "tests/openxr/calls/handles.h"

namespace test_runtime {

/// The context that the program gives with a session, which must be current and of OpenGL 4.5 at least.
GraphicsContext checked_context(const Instance& instance, const XrSessionCreateInfo& info);

bool is_current(const GraphicsContext& graphics);

/// Records it if the session's context is not current, or has an error. Whether the context can be used.
bool check_graphics(const Session& session);

/// Leaves an OpenGL error if the scenario says so.
void be_careless();

bool is_depth(int64_t format);

/// Textures that nothing can resize, in magenta, so that what a program does not draw is seen.
std::vector<uint32_t> make_textures(const XrSwapchainCreateInfo& info, std::size_t count);
void delete_textures(const std::vector<uint32_t>& textures);

/// The texels of a rectangle as they are stored, from the bottom row to the top row.
std::vector<uint8_t> colors_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer);
std::vector<float> depths_of(uint32_t texture, const XrRect2Di& rect, uint32_t layer);

}  // namespace test_runtime
