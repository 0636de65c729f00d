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
    nlohmann::json record = nlohmann::json::array();  ///< as frames.jsonl has it
    std::vector<SubmittedView> views;                 ///< of the first projection layer
};

/// The layers of a frame. The call ends if one of them is not valid.
SubmittedLayers checked_layers(XrSession session, const XrFrameEndInfo& info);

}  // namespace test_runtime
