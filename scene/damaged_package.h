#pragma once
#include <string>

#include "scene/error.h"

namespace vantage {

/// What makes a package unreadable, in whole or in part.
enum class Defect {
    not_a_package,    ///< too short for a header, or another file type
    unfinished,       ///< a share, or a preparation that was interrupted
    header_checksum,  ///< the header does not match its checksum
    format_version,   ///< written in another version of the format
    truncated,        ///< the file is shorter or longer than its header states
    directory,        ///< the directory does not match its checksum, or points outside the file
    chunk_missing,    ///< a required chunk is missing
    chunk_checksum,   ///< a chunk does not match its checksum
    invalid_record    ///< a record is out of range, or the number of records is wrong
};

/// An Error(damaged) that states the kind of defect.
class DamagedPackage : public Error {
  public:
    DamagedPackage(Defect defect, const std::string& message)
        : Error(Exit::damaged, message), defect_(defect) {}
    Defect defect() const { return defect_; }

  private:
    Defect defect_;
};

}  // namespace vantage
