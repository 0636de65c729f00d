#pragma once

namespace vantage {

/// The number of seconds since this process started, according to the kernel, to a hundredth of a second.
double seconds_since_start();

}  // namespace vantage
