#pragma once
#include <string>

namespace vantage {

/// The processor's model name from /proc/cpuinfo; "unknown processor" if it is not listed there.
std::string processor_name();

}  // namespace vantage
