#pragma once

namespace vantage {

/// Seconds since this process started, according to the kernel (in hundredths).
double seconds_since_start();

}  // namespace vantage
