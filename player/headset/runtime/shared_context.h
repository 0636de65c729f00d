#pragma once

namespace vantage {

/// Keeps the session's OpenGL context usable around calls to the runtime. Some runtimes leave errors in the
/// context, or leave another context current (SteamVR). Construct a SharedContext before an OpenXR call that
/// may draw or create objects; its destructor makes the context current again and clears errors.
class SharedContext {
  public:
    SharedContext();
    ~SharedContext();
    SharedContext(const SharedContext&) = delete;
    SharedContext& operator=(const SharedContext&) = delete;

  private:
    void* display_;
    void* context_;
    unsigned long drawable_ = 0;              ///< of GLX
    void *draw_ = nullptr, *read_ = nullptr;  ///< of EGL
    bool egl_;
};

}  // namespace vantage
