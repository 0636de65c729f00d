#pragma once
#include <mutex>

namespace test_runtime {

/// A mutex that the call being executed holds, except while it waits.
std::mutex& one_call();

}  // namespace test_runtime
