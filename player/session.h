#pragma once
#include <optional>
#include <string>
#include <vector>

#include "player/measure/frame_statistics.h"
#include "player/navigation.h"
#include "player/render/render_settings.h"

namespace vantage {

/// Panels and overlays that are shown.
struct Panels {
    bool blending = true, status = true, photos = true, frusta = false, radar = false, help = false;
};

/// What the window's user sees and changes.
struct Session {
    RenderSettings settings;
    Navigation camera;
    std::vector<std::uint32_t> photos;  ///< that may be blended
    Panels panels;

    std::uint32_t standing_at = 0;  ///< photo last flown to
    bool freeze = false;            ///< weights stay as they are

    /// A flight under way: to a photo, or along a recorded path.
    struct Flight {
        std::vector<Navigation> stops;
        double begun, seconds;
    };
    std::optional<Flight> flight;
    bool recording = false;
    std::vector<Navigation> recorded;

    bool open_asked = false;  ///< the dialog to open another package
    std::string open;         ///< another package to show
    bool screenshot = false, quit = false;
    std::string message;  ///< a line for the user
    double message_until = 0;

    FrameReport report;
    std::vector<float> frame_ms = std::vector<float>(240, 0.0f);  ///< of the last frames drawn, newest last
    FrameStatistics statistics;
};

void say(Session& session, const std::string& message, double now);

/// Flies to a photo's camera within a moment.
void fly_to(Session& session, std::uint32_t photo, const package::PhotoRecord& record, double now);
/// Flies along the recorded path once, 30 positions a second.
void replay(Session& session, double now);
/// Moves the camera as far as its flight has come.
void continue_flight(Session& session, double now);

}  // namespace vantage
