#pragma once
#include <atomic>

namespace vantage {

/// Installs handlers for SIGINT, SIGTERM and SIGHUP that set the returned flag and interrupt system calls, so
/// that what is half done can be removed.
const std::atomic<bool>& stop_requested();

}  // namespace vantage
