#include "pipeline/run/until_stopped.h"

#include <utility>

#include "base/text/error.h"

namespace vantage {

OnProgress until_stopped(const std::atomic<bool>* stop, std::string message, OnProgress report) {
    return [stop, message = std::move(message), report = std::move(report)](const Progress& p) {
        if (stop && *stop) throw Error(Exit::interrupted, message);
        if (report) report(p);
    };
}

}  // namespace vantage
