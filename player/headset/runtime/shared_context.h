#pragma once

namespace vantage {

/// The OpenGL context of a session while the runtime uses it. Runtimes are known to leave errors in it, and
/// another one current (SteamVR). Made before a call of OpenXR that may draw or create; when it ends, the
/// context is current again and without the runtime's errors.
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
