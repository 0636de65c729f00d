#pragma once
#include <cstddef>
#include <span>

namespace vantage {

/// Where a mapped package has been cut short, or its disk has gone, the system ends whoever reads on with
/// SIGBUS and no word. From now on this process then says so in one line, naming the file, and ends with
/// Exit::damaged. `program` must live on.
void name_lost_packages(const char* program);

/// Says which file these bytes are mapped from; the path must stay where it is until it is withdrawn.
void announce_mapping(std::span<const std::byte> bytes, const char* path);
void withdraw_mapping(std::span<const std::byte> bytes);

}  // namespace vantage
