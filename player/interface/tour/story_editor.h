#pragma once
#include "player/interface/overlays/note_markers.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"
#include "player/interface/tour/hiding_brush.h"

namespace vantage {

/// Moves a note's anchor to the surface at a pixel. Returns false if the pixel does not show the model.
/// `surface` may be empty, here and below, if no surface can be clicked.
bool place_note(ActiveStory& active, std::size_t note, const Session& session, const SurfaceAt& surface,
                const Eigen::Vector2d& pixel);

/// The panel for writing a story. The panel sets the title and the opening view, adds notes at points on the
/// surface that are clicked, edits the open note and its stops in tours, sorts the notes, makes a tour of
/// them, sets the titles of tours, and saves the story. Texts are edited in the displayed language.
class StoryEditor {
  public:
    /// The places at a pixel; either may be empty.
    struct Surfaces {
        SurfaceAt model, anything;  ///< on the mesh; on the mesh or else the background
    };

    /// `background`: whether the scene has a photographed background.
    explicit StoryEditor(bool background) : background_(background) {}
    /// Returns the height of the free area above the panel, which the story panel may use.
    double show(Controls& controls, ActiveStory& active, Session& session, const View& view,
                const Surfaces& surfaces, double now);

  private:
    void add(ActiveStory& active, const Session& session, const SurfaceAt& surface,
             const Eigen::Vector2d& pixel);
    void place_buttons(Controls& controls, ActiveStory& active, Session& session, const View& view,
                       const SurfaceAt& surface);
    void take_click(ActiveStory& active, Session& session, const SurfaceAt& surface, double now);
    void set_opening(ActiveStory& active, Session& session, double now) const;
    void fields(Controls& controls, ActiveStory& active);
    void buttons(Controls& controls, ActiveStory& active, const Session& session);
    void tours(Controls& controls, ActiveStory& active, Session& session, double now) const;
    void content(Controls& controls, ActiveStory& active, Session& session, const View& view,
                 const Surfaces& surfaces, double now);

    HidingBrush brush_;
    bool background_;
    bool moves_ = false;  ///< the next click moves the open note's anchor
};

}  // namespace vantage
