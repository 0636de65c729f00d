#pragma once

namespace vantage {

/// Call inside `catch (...)`: prints "PROGRAM: message" on stderr and returns the exit code for the exception
/// in flight. An Error keeps its own code, gl::Failure becomes Exit::graphics, a failed allocation
/// Exit::memory, a failed file operation Exit::storage, and anything else Exit::internal.
int report_exception(const char* program) noexcept;

}  // namespace vantage
