#pragma once
#include <string>
#include <vector>

#include "pipeline/costs/cost_chart.h"
#include "pipeline/costs/cost_table.h"
#include "pipeline/costs/costs.h"

namespace vantage {

/// The machine, program and date: "Vantage 0.6.1, 2026-11-30; ...".
std::string origin_of(const Costs& costs);

/// A row per scan: photos, triangles, and the costs and quality of the defaults.
TextTable scan_table(const Costs& costs);

/// A line per recommendation: purpose, commands and costs.
std::vector<std::string> recipes_in_words(const ScanCosts& scan);

/// A part of the page on accuracy and cost.
struct PagePart {
    enum Kind { heading, paragraph, list, table, chart, code } kind;
    std::vector<std::string> lines{};  ///< of headings, paragraphs, lists and code
    TextTable rows{};
    CostAxis axis{};
};
/// The page: answers, machine, charts, the table of settings, and recommendations. `costs` has at least one
/// scan.
std::vector<PagePart> page_parts(const Costs& costs);

/// The page as a self-contained HTML document.
std::string costs_page(const Costs& costs);

}  // namespace vantage
