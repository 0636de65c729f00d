#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vantage {

struct ProcessLimits {
    std::uint64_t bytes;  ///< memory in addition to that of this process
    unsigned seconds;     ///< CPU time
};

/// Runs `work`, which an untrusted file may crash, in a forked process and returns its result, which is empty
/// if `work` throws, crashes or exceeds the limits. Anything that the process prints is discarded. Throws
/// std::system_error if no process can be started.
std::vector<std::byte> run_isolated(const ProcessLimits& limits,
                                    const std::function<std::vector<std::byte>()>& work);

}  // namespace vantage
