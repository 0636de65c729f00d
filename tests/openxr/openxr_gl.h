#pragma once
/// OpenXR with its OpenGL structures, without those of a platform, which come with macros named None and
/// Bool.
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
