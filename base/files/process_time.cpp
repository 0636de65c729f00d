#include "base/files/process_time.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace vantage {

double seconds_since_start() {
    std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
    std::string field;
    double ticks = 0, up = 0;
    for (int i = 1; i <= 22 && stat >> field; ++i)
        if (i == 22) ticks = std::stod(field);
    uptime >> up;
    return up - ticks / double(::sysconf(_SC_CLK_TCK));
}

}  // namespace vantage
