#pragma once
// Records that the runtime writes to the folder VANTAGE_TEST_XR_OUT:
// violations.txt: violations of the specification, one per line: the function and the error
// events.txt: events of instances and sessions, one per line: the frame number and the event
// frames.jsonl: the layers submitted by each xrEndFrame (frame.cpp)
// 0010-left.png, 0010-right.png: saved pictures, as stored in the swapchain, 8 bits per channel
// 0010-left-depth.pfm, 0010-right-depth.pfm: the depth submitted with them, as in the depth buffer
#include <cstdint>
#include <string>
#include <vector>

namespace test_runtime {

void record_violation(const std::string& call, const std::string& what);
void record_event(int frame, const std::string& what);
void record_frame(const std::string& json);

/// Saves a picture whose bottom row comes first, as in OpenGL. The name has no extension.
void save_picture(const std::string& name, uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba);
void save_depth(const std::string& name, uint32_t width, uint32_t height, const std::vector<float>& depth);

}  // namespace test_runtime
