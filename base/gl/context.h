#pragma once
#include <memory>
#include <string>

namespace vantage::gl {

/// Whether the driver reports errors as they happen, for check() to throw. This slows drawing.
enum class Debug { off, on };

/// On if the environment variable VANTAGE_DEBUG_GL is set to anything but "0"; the tests set it.
Debug debug_from_environment();

/// A headless OpenGL 4.5 core context, current on the thread that created it. Tries EGL's hardware devices,
/// then its software devices, then surfaceless Mesa. Throws Failure if none of them provides a context.
class HeadlessContext {
  public:
    explicit HeadlessContext(Debug debug = debug_from_environment());
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// True if EGL lists a hardware device. The check is quick, because it creates no context.
bool has_hardware();

/// Properties of the current context.
struct Device {
    std::string renderer, version;
    bool software = false;  ///< rasterizes on the CPU (llvmpipe, softpipe, swrast)
};
Device current_device();

/// Records the current context's first error or high-severity message for check() on this thread. Drivers may
/// send no messages unless the context was created with the debug flag.
void watch_errors();

/// Clears pending errors, which other users of the context may have caused.
void forget_errors();

/// If an OpenGL error or a recorded message is pending, clears both and throws Failure naming `where`.
void check(const char* where);

}  // namespace vantage::gl
