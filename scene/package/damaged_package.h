#pragma once
#include <string>

#include "base/text/error.h"

namespace vantage {

/// A defect that makes a package unreadable, in whole or in part.
enum class Defect {
    not_a_package,    ///< the file is too short for a header, or is of another type
    unfinished,       ///< the file is a shard, or its preparation was interrupted
    header_checksum,  ///< the header does not match its checksum
    format_version,   ///< the file has an earlier version of the format
    newer_format,     ///< the file has a later version of the format
    truncated,        ///< the file is shorter or longer than its header states
    directory,        ///< the directory does not match its checksum, or an entry points outside the file
    chunk_missing,    ///< a required chunk is missing
    chunk_checksum,   ///< a chunk does not match its checksum
    tile_checksum,    ///< a tile does not match its checksum
    invalid_record    ///< a value in a record is out of range, or the number of records is wrong
};

/// An error that states the defect. The error is Error(damaged), or Error(input) if the package may be valid
/// but has a different version.
class DamagedPackage : public Error {
  public:
    DamagedPackage(Defect defect, const std::string& message)
        : Error(defect == Defect::format_version || defect == Defect::newer_format ? Exit::input
                                                                                   : Exit::damaged,
                message),
          defect_(defect) {}
    Defect defect() const { return defect_; }

  private:
    Defect defect_;
};

}  // namespace vantage
