#pragma once
/// OpenXR with its OpenGL structures, but without platform structures, whose headers define macros named None
/// and Bool.
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
