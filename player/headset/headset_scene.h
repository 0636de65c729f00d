#pragma once
#include <functional>
#include <vector>

#include "player/headset/headset_marks.h"
#include "player/headset/headset_menu.h"
#include "player/headset/locomotion/locomotion.h"
#include "player/headset/locomotion/pointing.h"
#include "player/headset/locomotion/vignette.h"
#include "player/headset/menu_place.h"
#include "player/headset/runtime/depth_picture.h"
#include "player/headset/runtime/headset_session.h"
#include "player/headset/scene_interface.h"
#include "player/interface/state/session.h"
#include "player/options/show_options.h"
#include "player/panels/mark_pass.h"
#include "player/render/timing/frame_clock.h"
#include "player/window/loaded_scene.h"

namespace vantage {

/// Shows a scene in a headset, frame by frame. The package and the session must outlive the HeadsetScene.
/// Use it only on the OpenGL thread.
class HeadsetScene {
  public:
    HeadsetScene(const PackageReader& package, const std::vector<SceneObject>& objects,
                 const ShowOptions& options, Session& session);

    /// Draws and ends a frame that has begun. `seen`: called with the framebuffer and the size of the left
    /// eye's picture.
    void frame(HeadsetSession& headset, const HeadsetFrame& frame,
               const std::function<void(GLuint, FrameSize)>& seen);

  private:
    void place(const RoomPose& head);
    void follow_head(const HeadsetFrame& frame);
    void take_menu_button(const HeadsetFrame& frame);
    void place_panel();
    void point(const HeadsetFrame& frame);
    bool chosen(const Hands& hands, std::size_t hand) const;
    void act(const HeadsetFrame& frame);
    FreeHands free_hands() const;
    void move(const HeadsetFrame& frame, double seconds);
    void write_interface(const HeadsetFrame& frame, double seconds);
    std::vector<SceneLabel> labels(const HeadsetFrame& frame) const;
    void continue_tour(const HeadsetFrame& frame);
    void stand_where_sent(const HeadsetFrame& frame);
    void stand_at_stop(const HeadsetFrame& frame);
    void mark(const HeadsetFrame& frame);
    std::array<View, 2> views_of(const HeadsetFrame& frame, FrameSize size) const;
    void draw(HeadsetSession& headset, const HeadsetFrame& frame,
              const std::function<void(GLuint, FrameSize)>& seen);
    void draw_over(const View& view, const DrawnDepth& depth, GLuint target);
    std::optional<DepthLimits> depth_of(HeadsetSession& headset, const DrawnDepth& depth, FrameSize size,
                                        std::size_t eye);
    void keep_pace();

    LoadedScene scene_;
    Session& session_;
    Eigen::Vector3d origin_;  ///< the package's origin, in input coordinates
    Eigen::Vector3d up_;      ///< of the scene
    double unit_meters_;      ///< meters per scene unit; 0: unknown
    double fps_;              ///< target rate, see frame_goal(); below 0: the headset's rate
    std::string controls_;    ///< output file for the positions of the menu's controls
    Locomotion locomotion_;
    bool placed_ = false, dims_edges_ = true;

    SceneInterface interface_;
    std::optional<MenuPlace> menu_;  ///< set while the menu is open
    std::optional<Panel> panel_;     ///< the menu's panel in this frame
    MenuPage page_ = MenuPage::move;
    struct Stop {
        std::size_t number;
        double started;  ///< start of the tour, seconds
        Stance stood;
    };
    std::optional<Stop> stop_;  ///< current stop of the tour
    std::array<Pointed, 2> pointed_;
    std::array<bool, 2> selected_{};             ///< whether each hand selected in the last frame
    bool menu_pressed_ = false, gazed_ = false;  ///< likewise
    std::vector<DrawnMeasurement> measured_;     ///< in this frame
    MenuPointer menu_pointer_;
    Marks marks_, hand_marks_;
    MarkPass mark_pass_, hand_pass_;
    Vignette vignette_;

    FrameClock clock_;
    double goal_ms_ = 0;
    Pacing pacing_;
    double time_ = 0;  ///< time of the last frame, seconds
    DepthPicture depth_;
    std::vector<DrawnEye> drawn_;  ///< of this frame
};

}  // namespace vantage
