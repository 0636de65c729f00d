#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// One thing that was checked, for programs that read JUnit's XML.
struct CheckCase {
    std::string name;        ///< of the package, or the picture
    std::string kind, text;  ///< what is wrong: one word, and all of it; empty where it is well
    double seconds = 0;
};

/// Writes JUnit's XML. Throws Error(storage).
void write_junit(const std::filesystem::path& file, const std::string& suite,
                 const std::vector<CheckCase>& cases);

}  // namespace vantage
