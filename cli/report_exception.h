#pragma once

namespace vantage {

/// Call inside `catch (...)`: prints "PROGRAM: message" on stderr and returns the exit code for the exception
/// in flight. Error gives its own code, gl::Failure graphics, a failed allocation memory, a failed file
/// operation storage; all else is an internal error.
int report_exception(const char* program) noexcept;

}  // namespace vantage
