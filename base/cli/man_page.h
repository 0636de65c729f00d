#pragma once
#include <string>
#include <vector>

#include "base/cli/described_command.h"

namespace vantage {

/// A manual page in the man macros of roff.
struct ManPage {
    std::string name;  ///< such as "vantage-prepare"
    std::string text;
};

/// The pages of programs of one version, and of their verbs; each refers to those related to it.
std::vector<ManPage> man_pages(const std::vector<DescribedCommand>& programs, const std::string& version);

}  // namespace vantage
