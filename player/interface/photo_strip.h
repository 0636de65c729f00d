#pragma once
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "player/interface/overlays/photo_marks.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Thumbnails of the photos at the bottom of the window, in order of decreasing agreement with the view.
/// Clicking a thumbnail flies to its photo; the wheel and dragging scroll the strip.
class PhotoStrip {
  public:
    ~PhotoStrip();
    void show(Controls& controls, Session& session, Renderer& renderer, const View& view, const Area& area,
              double now);
    /// Shows a photo's name and thumbnail next to the pointer.
    void tooltip(Renderer& renderer, std::uint32_t photo);
    /// Sorts the photos again, and scrolls to the first one.
    void start_over() { sorted_by_.clear(); }
    /// Time at which the photos' agreement with the view is due to be found again, in seconds.
    double ranks_at() const { return outdated_ ? ranked_at_ + ranking_seconds : HUGE_VAL; }
    /// Whether a visible thumbnail is still missing.
    bool lacks_pictures() const { return lacks_; }

  private:
    static constexpr double ranking_seconds = 0.5;
    static constexpr float drag_pixels = 6;
    void rank(const Session& session, const PlanScene& scene, const View& view, double now);
    std::vector<std::uint32_t> order(const Session& session, const PlanScene& scene) const;
    bool scroll(const Area& area) const;
    void thumbnail(Renderer& renderer, std::uint32_t photo, ImVec2 low, ImVec2 high);
    void explain(const PlanScene& scene, std::uint32_t photo, const PhotoState& state) const;
    GLuint picture(const Residency& residency, std::uint32_t layer);
    void forget();

    GLuint array_ = 0;                          ///< the texture that pictures_ are views of
    std::map<std::uint32_t, GLuint> pictures_;  ///< by layer
    std::vector<double> agreements_;            ///< with ranked_view_
    std::vector<double> sorted_by_;             ///< these, or earlier ones while the strip is in use
    std::optional<View> ranked_view_;
    double ranked_at_ = 0;  ///< seconds
    bool outdated_ = false, lacks_ = false;
};

}  // namespace vantage
