#include "pipeline/run/progress.h"

#include <utility>

#include "scene/error.h"

namespace vantage {

OnProgress until_stopped(const std::atomic<bool>* stop, std::string kept, OnProgress report) {
    return [stop, kept = std::move(kept), report = std::move(report)](const Progress& p) {
        if (stop && *stop) throw Error(Exit::interrupted, kept);
        if (report) report(p);
    };
}

}  // namespace vantage
