#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace vantage {

/// Accepts a number from `least` to `most`, both included. Unlike CLI::Range, it rejects NaN.
inline CLI::Validator real_range(double least, double most) {
    const std::string range = CLI::Range(least, most).get_description();
    const auto refuse = [=](const std::string& text) {
        double value = 0;
        const bool within = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
        return within ? std::string() : "Value " + text + " not in range " + range;
    };
    return {refuse, range};
}

}  // namespace vantage
