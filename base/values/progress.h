#pragma once
#include <cstddef>
#include <string>

namespace vantage {

/// The progress of a long operation.
struct Progress {
    const char* stage;
    std::string photo;  ///< name of the photo or other item; empty if the step concerns the whole scene
    std::size_t done, total;
};

}  // namespace vantage
