#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "player/measure/bench/flight.h"

namespace vantage {

/// Statistics of all repeats of one path in one mode. `upload_budget`: bytes per frame.
nlohmann::json summarize(const std::vector<const Flight*>& flights, std::size_t upload_budget);

/// Prints a summary in one line.
void print_summary(const nlohmann::json& summary);

/// Writes one line per frame of all flights, as CSV. Throws Error(storage).
void write_frames(const std::filesystem::path& file, const std::vector<Flight>& flights);

}  // namespace vantage
