#pragma once
#include <mutex>

namespace test_runtime {

/// Held by the executing call, except while it waits.
std::mutex& one_call();

}  // namespace test_runtime
