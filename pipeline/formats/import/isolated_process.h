#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vantage {

struct ProcessLimits {
    std::uint64_t bytes;  ///< of memory more than this process has
    unsigned seconds;     ///< of processor time
};

/// Runs code that a file from strangers may bring down in a process of its own, and returns what it returned;
/// nothing where it threw, died or went beyond the limits. Whatever it prints is lost. Throws
/// std::system_error where no process can be made.
std::vector<std::byte> run_isolated(const ProcessLimits& limits,
                                    const std::function<std::vector<std::byte>()>& work);

}  // namespace vantage
