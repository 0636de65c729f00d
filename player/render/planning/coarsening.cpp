#include "player/render/planning/coarsening.h"

#include <chrono>

namespace vantage {

Coarsening::Coarsening(const PlanScene& scene) {
    std::promise<CoarseMesh> promise;
    made_ = promise.get_future();
    thread_ = std::jthread([&scene, promise = std::move(promise)](const std::stop_token& stop) mutable {
        try {
            promise.set_value(make_coarse_mesh(scene, stop));
        } catch (...) {  // without memory for it, frames use the full mesh
            promise.set_value({});
        }
    });
}

std::optional<CoarseMesh> Coarsening::take(bool wait) {
    if (!made_.valid()) return {};
    if (!wait && made_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    return made_.get();
}

}  // namespace vantage
