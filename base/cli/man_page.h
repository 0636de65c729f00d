#pragma once
#include <string>
#include <vector>

#include "base/cli/described_command.h"

namespace vantage {

/// A manual page, written in roff's man macros.
struct ManPage {
    std::string name;  ///< such as "vantage-prepare"
    std::string text;
};

/// The pages of the programs and their verbs; each refers to related pages.
std::vector<ManPage> man_pages(const std::vector<DescribedCommand>& programs, const std::string& version);

}  // namespace vantage
