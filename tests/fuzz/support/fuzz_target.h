#pragma once
// Defines a fuzz target, which libFuzzer calls: FUZZ_TARGET(name)(const std::uint8_t* data, std::size_t size)
// {...} In the main build, where FUZZ_CORPUS is the folder of all corpora, a test replays the target's
// corpus.
#include <cstdint>

#ifdef FUZZ_CORPUS
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace vantage::fuzz {

/// Calls `target` with each file of the target's corpus.
template <class Target>
void replay(const std::string& name, const Target& target) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(FUZZ_CORPUS "/" + name)) {
        std::ifstream in(entry.path(), std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
        target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        ++files;
    }
    EXPECT_GT(files, 0u) << name;
}

}  // namespace vantage::fuzz

#define FUZZ_TARGET(name)                                           \
    static int fuzz_##name(const std::uint8_t*, std::size_t);       \
    TEST(Fuzz, name) { vantage::fuzz::replay(#name, fuzz_##name); } \
    static int fuzz_##name
#else
#define FUZZ_TARGET(name) extern "C" int LLVMFuzzerTestOneInput
#endif
