#pragma once

namespace vantage {

/// Makes the heap use large pages, which the kernel does not zero and map 4 KiB at a time, and reuse freed
/// memory. Page faults in new memory take most of the time of a first picture (a hundred MiB of textures) and
/// a fifth of the time of preparing photos. Call this at program start, before there are threads. It has no
/// effect without glibc, or if the kernel provides no large pages on request.
void use_large_pages();

}  // namespace vantage
