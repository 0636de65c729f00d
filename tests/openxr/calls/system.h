#pragma once
#include "tests/openxr/calls/handles.h"

namespace test_runtime {

constexpr uint32_t max_swapchain_side = 8192, max_layers = 16;

/// Ends the call if there is no such system or view configuration.
void check_system(XrSystemId system);
void check_view_configuration(XrViewConfigurationType type);

}  // namespace test_runtime
