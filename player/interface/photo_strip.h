#pragma once
#include <map>

#include "player/render/renderer.h"
#include "player/session.h"

namespace vantage {

/// The photos' thumbnails along the lower edge, those that agree best with the view first (PhotoCloud); a
/// click flies to that photo.
class PhotoStrip {
  public:
    ~PhotoStrip();
    void show(Session& session, Renderer& renderer, const View& view, double now);

  private:
    GLuint picture(const Residency& residency, std::uint32_t layer);
    void forget();

    GLuint array_ = 0;                          ///< of which pictures_ are views
    std::map<std::uint32_t, GLuint> pictures_;  ///< a layer
    std::vector<double> agreements_;
    double ranked_at_ = -1;
};

}  // namespace vantage
