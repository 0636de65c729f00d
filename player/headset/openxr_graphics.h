#pragma once
// OpenXR with its OpenGL bindings for X11 and EGL. For sources only: X11 has macros with common names. Those
// that others use here are removed.
#include <epoxy/egl.h>
#include <epoxy/glx.h>
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
#undef KeyPress
#undef None
#undef Status
#undef Success
#undef Bool
#undef Always
