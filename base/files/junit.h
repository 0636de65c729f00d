#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// The result of one check, as a JUnit test case.
struct CheckCase {
    std::string name;        ///< name of the package or picture
    std::string kind, text;  ///< the failure as one word and in full; both are empty if the check passed
    double seconds = 0;
};

/// Writes the cases as JUnit XML. Throws Error(storage).
void write_junit(const std::filesystem::path& file, const std::string& suite,
                 const std::vector<CheckCase>& cases);

}  // namespace vantage
