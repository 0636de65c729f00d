#pragma once
#include <map>

#include "player/interface/controls.h"
#include "player/interface/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The photos' thumbnails along the lower edge, by decreasing agreement with the view. A click
/// flies to that photo.
class PhotoStrip {
  public:
    ~PhotoStrip();
    void show(Controls& controls, Session& session, Renderer& renderer, const View& view, double now);

  private:
    GLuint picture(const Residency& residency, std::uint32_t layer);
    void forget();

    GLuint array_ = 0;                          ///< texture that pictures_ are views of
    std::map<std::uint32_t, GLuint> pictures_;  ///< by layer
    std::vector<double> agreements_;
    double ranked_at_ = -1;
};

}  // namespace vantage
