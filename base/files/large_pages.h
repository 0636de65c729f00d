#pragma once

namespace vantage {

/// Lets the heap take memory from the kernel in large pages, which are not zeroed and mapped 4 KiB at a time,
/// and use what is freed again: first writing to new memory is most of a first picture (textures of a hundred
/// MiB) and a fifth of preparing photos. At the start of a program, before it has threads. Without effect
/// where the C library is not glibc, or the kernel gives no large pages on request.
void use_large_pages();

}  // namespace vantage
