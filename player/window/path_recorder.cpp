#include "player/window/path_recorder.h"

#include <algorithm>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/view/camera_path.h"
#include "player/window/input/numbered_file.h"

namespace vantage {
namespace {

void save_path(Session& s, const PackageReader& package, double now) {
    const std::vector<Navigation>& positions = s.path.positions;
    if (positions.empty()) return;
    write_numbered(
        s.message, stem_for_files(package), ".path",
        formatted(tr_in("written", "%zu positions"), positions.size()), now,
        [&](const std::string& file) { write_path(file, positions, package, {}, positions_per_second); });
}

}  // namespace

/// Records `positions_per_second` positions per second, interpolated between frames. At rest, there were no
/// frames, since the camera did not move.
void PathRecorder::attend(Session& s, bool rests, const PackageReader& package, double now) {
    RecordedPath& path = s.path;
    const Navigation& camera = s.viewpoint.camera;
    if (!recording_ || (path.recording && path.positions.empty())) {
        if (!path.recording) return;
        recording_ = Recording{now, camera, now};
    }
    if (rests) recording_->last_at = std::max(recording_->last_at, now - 1 / positions_per_second);
    const auto next = [&] {
        return recording_->begin + double(path.positions.size()) / positions_per_second;
    };
    for (double at; (at = next()) <= now;) {
        const double passed = now - recording_->last_at;
        const double share = passed > 0 ? std::clamp((at - recording_->last_at) / passed, 0.0, 1.0) : 1;
        path.positions.push_back(between(recording_->last, camera, share));
    }
    recording_->last = camera;
    recording_->last_at = now;
    if (path.recording) return;
    save_path(s, package, now);
    recording_.reset();
}

}  // namespace vantage
