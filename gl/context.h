#pragma once
#include <memory>
#include <string>

namespace vantage::gl {

/// A headless OpenGL 4.5 core context, current on the thread that made it. Tries EGL's device platform for a
/// hardware device first, then surfaceless Mesa, then any device (software). Throws
/// Failure naming what was tried when none works.
class HeadlessContext {
  public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Is there a device that is no software? Quick: makes no context.
bool has_hardware();

/// Facts of the current context.
struct Device {
    std::string renderer, version;
    bool software = false;  ///< rasterises on the processor (llvmpipe, softpipe, swrast)
    int max_texture_size = 0, max_array_layers = 0;
};
Device current_device();

/// Keeps the first message of high severity for check(), which throws it. Needs a current context.
void watch_errors();

/// Throws Failure with `where` when OpenGL has an error pending.
void check(const char* where);

}  // namespace vantage::gl
