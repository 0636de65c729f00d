#pragma once
// OpenXR with its OpenGL bindings for X11 and EGL. For sources only: X11 defines macros with common names.
// KeyPress is undefined because the window has a struct of that name.
#include <epoxy/egl.h>
#include <epoxy/glx.h>
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#define XR_USE_PLATFORM_EGL
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>
#undef KeyPress
