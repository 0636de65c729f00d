#pragma once
#include <functional>

namespace vantage {

/// Call inside `catch (...)`: prints "PROGRAM: message" on stderr, puts it into results() and returns the
/// exit code for the exception in flight. An Error keeps its own code, gl::Failure becomes Exit::graphics, a
/// failed allocation Exit::memory, a failed file operation Exit::storage, and anything else Exit::internal.
int report_exception(const char* program) noexcept;

/// Calls `run`, reports any exception, and prints results(). Returns the exit code of `run` or of the
/// exception.
int run_reported(const char* program, const std::function<int()>& run) noexcept;

}  // namespace vantage
