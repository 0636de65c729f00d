#pragma once

namespace vantage {

/// Seconds since this process started, according to the kernel, to a hundredth of a second.
double seconds_since_start();

}  // namespace vantage
