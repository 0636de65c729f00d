#include "base/cli/report_exception.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <ios>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/cli/standard_output.h"
#include "base/gl/failure.h"
#include "base/text/error.h"

namespace vantage {

int report_exception(const char* program) noexcept {
    const auto report = [program](Exit code, const char* message) {
        std::fprintf(stderr, "%s: %s%s\n", program, code == Exit::internal ? "internal error: " : "",
                     message);
        try {
            results()["error"] = {{"exit_code", int(code)}, {"message", message}};
        } catch (const std::bad_alloc&) {  // already reported
        }
        return int(code);
    };
    const auto out_of_memory = [&] { return report(Exit::memory, "out of memory"); };
    try {
        throw;
    } catch (const Error& e) {
        return report(e.code(), e.what());
    } catch (const gl::Failure& e) {
        return report(Exit::graphics, e.what());
    } catch (const std::bad_alloc&) {
        return out_of_memory();
    } catch (const std::filesystem::filesystem_error& e) {
        const bool loop = e.code() == std::errc::too_many_symbolic_link_levels;
        return report(loop ? Exit::input : Exit::storage, e.what());
    } catch (const std::ios_base::failure& e) {
        return report(Exit::storage, e.what());
    } catch (const std::system_error& e) {
        if (e.code() == std::errc::not_enough_memory) return out_of_memory();
        if (e.code() == std::errc::resource_unavailable_try_again)
            return report(
                Exit::memory,
                "cannot start another thread or process: out of memory, or too many threads or processes");
        return report(Exit::internal, e.what());
    } catch (const std::exception& e) {
        return report(Exit::internal, e.what());
    } catch (...) {
        return report(Exit::internal, "unknown exception");
    }
}

int run_reported(const char* program, const std::function<int()>& run) noexcept {
    int code = int(Exit::internal);
    try {
        code = run();
    } catch (...) {
        code = report_exception(program);
    }
    print_results(code);
    return code;
}

}  // namespace vantage
