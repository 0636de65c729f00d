#pragma once

namespace vantage {

/// Makes the heap use large pages, so that the kernel does not zero and map only 4 KiB at a time, and makes
/// the heap reuse freed memory. Otherwise, page faults in new memory take up most of the time before the
/// first picture, which needs a hundred MiB of textures, and a fifth of the time for preparing photos. Call
/// this at program start, before any thread is started. The call has no effect without glibc or if the kernel
/// does not provide large pages on request.
void use_large_pages();

}  // namespace vantage
