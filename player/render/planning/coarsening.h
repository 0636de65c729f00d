#pragma once
#include <future>
#include <optional>
#include <thread>

#include "player/plan/coarse_mesh.h"

namespace vantage {

/// Makes a scene's coarse mesh on a separate thread. The scene must outlive it.
class Coarsening {
  public:
    explicit Coarsening(const PlanScene& scene);
    /// The finished mesh; each mesh is returned only once. With `wait`, blocks until the mesh is finished.
    std::optional<CoarseMesh> take(bool wait);

  private:
    std::future<CoarseMesh> made_;
    std::jthread thread_;
};

}  // namespace vantage
