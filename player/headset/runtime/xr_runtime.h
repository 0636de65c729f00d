#pragma once
#include <string>

#include "player/headset/runtime/openxr.h"

namespace vantage {

/// Extensions used by this program that the runtime supports.
struct XrExtensions {
    bool egl = false, depth = false, microsoft_hands = false, hands = false;
};

/// A connection to the OpenXR runtime.
class XrRuntime {
  public:
    /// Throws Error(graphics) if there is no runtime, or it cannot be used with OpenGL.
    XrRuntime();
    ~XrRuntime();
    XrRuntime(const XrRuntime&) = delete;
    XrRuntime& operator=(const XrRuntime&) = delete;

    XrInstance get() const { return instance_; }
    const XrExtensions& extensions() const { return extensions_; }
    /// Name and version, as reported by the runtime.
    const std::string& name() const { return name_; }
    XrPath path(const char* text) const;

  private:
    XrInstance instance_ = XR_NULL_HANDLE;
    XrExtensions extensions_;
    std::string name_;
};

/// Whether a runtime responds; after a loss it may be unavailable for a while.
bool runtime_answers();

/// The headset. Throws Error(graphics) if no headset is found.
XrSystemId headset_of(const XrRuntime& runtime);

}  // namespace vantage
