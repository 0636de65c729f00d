#pragma once
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "scene/remote/remote_file.h"
#include "tests/scene/remote/fault_server.h"
#include "tests/temporary_folder.h"

namespace vantage {

/// A test that has its own cache and short timeouts.
class RemoteTest : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        for (const char* name : {"http_proxy", "https_proxy", "all_proxy", "ALL_PROXY", "HTTPS_PROXY"})
            ::unsetenv(name);
        options.cache = dir / "cache";
        options.connect_timeout = std::chrono::seconds(5);
        options.stall_timeout = std::chrono::seconds(10);  // a busy machine may stall
        options.retry_pause = std::chrono::milliseconds(20);
        options.first_bytes = block;
    }

    static constexpr std::uint64_t block = 64 << 10;
    RemoteOptions options;

    /// The message of the error that `f` throws; empty if `f` throws none. The error must have this code, and
    /// its message must be a single line.
    static std::string error_of(const std::function<void()>& f, Exit code = Exit::input) {
        try {
            f();
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), code) << e.what();
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            return e.what();
        }
        return {};
    }

    static bool fetch(RemoteFile& file, ByteRange range) { return file.fetch({&range, 1}); }
    static std::string text(const RemoteFile& file, ByteRange range) {
        const auto bytes = file.bytes().subspan(range.begin, range.size());
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    /// Whether the bytes are those of the original.
    static ::testing::AssertionResult same(const RemoteFile& file, ByteRange range,
                                           const std::string& original) {
        for (std::uint64_t at = range.begin; at < range.end; ++at)
            if (file.bytes()[at] != std::byte(original[at]))
                return ::testing::AssertionFailure() << "byte " << at << " differs";
        return ::testing::AssertionSuccess();
    }

    static void write(const std::filesystem::path& path, const std::string& content) {
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << content;
    }

    /// The disk usage of all files in the cache, in bytes.
    std::uint64_t cache_on_disk() const {
        std::uint64_t bytes = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(options.cache)) {
            struct stat st {};
            if (entry.is_regular_file() && ::lstat(entry.path().c_str(), &st) == 0)
                bytes += std::uint64_t(st.st_blocks) * 512;
        }
        return bytes;
    }
};

}  // namespace vantage
