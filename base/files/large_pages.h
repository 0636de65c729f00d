#pragma once

namespace vantage {

/// Makes the heap use large pages, so that the kernel does not zero and map 4 KiB at a time, and makes it
/// reuse freed memory. Otherwise, page faults in new memory take most of the time to the first picture (a
/// hundred MiB of textures) and a fifth of the time for preparing photos. Call this at program start, before
/// any thread is started. It has no effect without glibc, or if the kernel provides no large pages on
/// request.
void use_large_pages();

}  // namespace vantage
