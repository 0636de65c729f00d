#pragma once
#include <variant>
#include <vector>

#include "player/interface/sections/measure_panel.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"

namespace vantage {

/// The changes of a scene's story, measurements and settings, which a user can undo and redo.
class UndoHistory {
  public:
    /// Records the changes since the last call, and executes the commands Undo and Redo. To be called once
    /// per frame, before the interface. Changes by a control or a mouse button in use are recorded as one
    /// step when it is released, or when another one is used.
    void attend(Session& session, ActiveStory& active, MeasurePanel& measure, double now);

  private:
    template <class T>
    struct Step {
        T before, after;
    };
    static constexpr std::size_t most_steps = 200;

    void record(const Session& session, const ActiveStory& active, const MeasurePanel& measure);
    template <class T>
    void record(T& last, const T& now, bool is_change);
    void move(Session& session, ActiveStory& active, MeasurePanel& measure, bool back, double now);

    /// As recorded last.
    Story story_;
    Survey survey_;
    SessionSettings settings_;
    int reads_ = -1;  ///< of the measurements
    /// Frames during which changes are adjustments by the window, not by the user.
    int settling_ = 2;
    std::vector<std::variant<Step<Story>, Step<Survey>, Step<SessionSettings>>> steps_;
    std::size_t done_ = 0;  ///< the steps that are not undone
    unsigned control_ = 0;  ///< ImGui's ID of the control in use; 0: none
};

}  // namespace vantage
