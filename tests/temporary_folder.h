#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace vantage {

/// A test fixture with its own folder, which is removed after the test.
class TemporaryFolder : public ::testing::Test {
  protected:
    const std::filesystem::path dir =
        std::filesystem::temp_directory_path() / ("vantage-test-" + std::to_string(::getpid()));

    void SetUp() override { std::filesystem::create_directories(dir); }
    void TearDown() override { std::filesystem::remove_all(dir); }

    static std::string slurp(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        std::ostringstream bytes;
        if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
        return std::move(bytes).str();
    }
};

}  // namespace vantage
