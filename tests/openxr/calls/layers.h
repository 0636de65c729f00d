#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/openxr/calls/handles.h"

namespace test_runtime {

struct SubmittedView {
    XrSwapchainSubImage color;
    std::optional<XrSwapchainSubImage> depth;
};

struct SubmittedLayers {
    nlohmann::json record = nlohmann::json::array();  ///< as in frames.jsonl
    std::vector<SubmittedView> views;                 ///< views of the first projection layer
};

/// Checks the layers of a frame. Ends the call if any layer is invalid.
SubmittedLayers checked_layers(XrSession session, const XrFrameEndInfo& info);

}  // namespace test_runtime
