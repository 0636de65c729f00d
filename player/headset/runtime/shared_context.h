#pragma once

namespace vantage {

/// Makes the session's OpenGL context usable around calls of the runtime. Some runtimes leave errors in it,
/// or another context current (SteamVR). Construct it before a call of OpenXR that may draw or create; its
/// destructor makes the context current again and clears errors.
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
