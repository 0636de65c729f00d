#pragma once
#include <stdexcept>

namespace vantage::gl {

/// OpenGL is missing or failed; the message fits on one line unless it carries a driver's log.
class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace vantage::gl
