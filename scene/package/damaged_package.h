#pragma once
#include <string>

#include "base/text/error.h"

namespace vantage {

/// What makes a package unreadable, in whole or in part.
enum class Defect {
    not_a_package,    ///< too short for a header, or another file type
    unfinished,       ///< a share, or a preparation that was interrupted
    header_checksum,  ///< the header does not match its checksum
    format_version,   ///< written in an earlier version of the format
    newer_format,     ///< written in a later version of the format
    truncated,        ///< the file is shorter or longer than its header states
    directory,        ///< the directory does not match its checksum, or points outside the file
    chunk_missing,    ///< a required chunk is missing
    chunk_checksum,   ///< a chunk does not match its checksum
    tile_checksum,    ///< a tile does not match its checksum
    invalid_record    ///< a record is out of range, or the number of records is wrong
};

/// An error that states the kind of defect: Error(damaged), or Error(input) if the package may be valid but
/// is of another version.
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
