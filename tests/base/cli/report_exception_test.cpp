#include "base/cli/report_exception.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "base/gl/failure.h"
#include "base/text/error.h"

using namespace vantage;

namespace {

struct Report {
    Exit code;
    std::string text;
};

template <class E>
Report report(const E& exception) {
    testing::internal::CaptureStderr();
    int code = 0;
    try {
        throw exception;
    } catch (...) {
        code = report_exception("vantage");
    }
    return {Exit(code), testing::internal::GetCapturedStderr()};
}

}  // namespace

TEST(ReportException, KeepsTheCodeOfAnError) {
    const Report r = report(Error(Exit::damaged, "a.vantage: truncated"));
    EXPECT_EQ(r.code, Exit::damaged);
    EXPECT_EQ(r.text, "vantage: a.vantage: truncated\n");
}

TEST(ReportException, MapsOpenGlFailuresToGraphics) {
    const Report r = report(gl::Failure("no OpenGL 4.5"));
    EXPECT_EQ(r.code, Exit::graphics);
    EXPECT_EQ(r.text, "vantage: no OpenGL 4.5\n");
}

TEST(ReportException, DistinguishesMemoryFromStorage) {
    const Report memory = report(std::bad_alloc());
    EXPECT_EQ(memory.code, Exit::memory);
    EXPECT_EQ(memory.text, "vantage: out of memory\n");
    EXPECT_EQ(report(std::system_error(std::make_error_code(std::errc::not_enough_memory), "fork")).code,
              Exit::memory);
    EXPECT_EQ(
        report(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again), "thread"))
            .code,
        Exit::memory);
    const Report storage = report(std::filesystem::filesystem_error(
        "rename", "/full/a.part", std::make_error_code(std::errc::no_space_on_device)));
    EXPECT_EQ(storage.code, Exit::storage);
    EXPECT_NE(storage.text.find("/full/a.part"), std::string::npos);
}

TEST(ReportException, ReportsAnythingElseAsInternalError) {
    const Report r = report(std::logic_error("a chunk was written that was not planned"));
    EXPECT_EQ(r.code, Exit::internal);
    EXPECT_EQ(r.text, "vantage: internal error: a chunk was written that was not planned\n");
    EXPECT_EQ(report(42).code, Exit::internal);
    EXPECT_EQ(report(std::system_error(std::make_error_code(std::errc::io_error), "pipe")).code,
              Exit::internal);
}
