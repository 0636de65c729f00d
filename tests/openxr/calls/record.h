#pragma once
// What the runtime has seen, in the folder VANTAGE_TEST_XR_OUT:
// violations.txt: breaches of the specification, one a line: the function and what is wrong
// events.txt: what happened to instances and sessions, one a line: the number of the frame and what
// frames.jsonl: what each xrEndFrame submitted (frame.cpp)
// 0010-left.png, 0010-right.png: saved pictures, as stored in the swapchain, 8 bits per channel
// 0010-left-depth.pfm, 0010-right-depth.pfm: the depth that came with them, as in the depth buffer
#include <cstdint>
#include <string>
#include <vector>

namespace test_runtime {

void record_violation(const std::string& call, const std::string& what);
void record_event(int frame, const std::string& what);
void record_frame(const std::string& json);

/// Rows from the bottom to the top, as OpenGL has them. The name is without its ending.
void save_picture(const std::string& name, uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba);
void save_depth(const std::string& name, uint32_t width, uint32_t height, const std::vector<float>& depth);

}  // namespace test_runtime
