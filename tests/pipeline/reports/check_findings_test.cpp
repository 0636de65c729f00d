// The findings of vantage check: their identifiers, and their page in docs/.
#include "pipeline/reports/check_findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <vector>

using namespace vantage;

TEST(CheckFindings, IdentifiersAreUniqueAndInKebabCase) {
    std::set<std::string> ids;
    for (const FindingRow& row : finding_table()) {
        const std::string id = row.id;
        EXPECT_TRUE(ids.insert(id).second) << id;
        EXPECT_TRUE(std::ranges::all_of(id, [](char c) { return c == '-' || (c >= 'a' && c <= 'z'); })) << id;
        EXPECT_EQ(&finding_row(row.finding), &row) << id;
    }
}

TEST(CheckFindings, IntactPackagesGetWarningsOnly) {
    for (const FindingRow& row : finding_table()) {
        const bool intact = row.kind == Exit::stale || row.kind == Exit::incomplete;
        EXPECT_EQ(row.severity == Severity::warning, intact) << row.id;
    }
}

TEST(CheckFindings, ThePageListsTheTable) {
    std::vector<std::string> expected, listed;
    for (const FindingRow& row : finding_table()) expected.push_back(markdown_row(row));
    std::ifstream page(VANTAGE_SOURCE_DIR "/docs/check-findings.md");
    for (std::string line; std::getline(page, line);)
        if (line.starts_with("| `")) listed.push_back(line);
    EXPECT_EQ(listed, expected);
}
