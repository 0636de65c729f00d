#include "base/files/large_pages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace vantage {

void use_large_pages() {
#ifdef __GLIBC__
    constexpr int at_once = 512 << 20;         // address space; memory is allocated on first write
    constexpr int largest_in_heap = 32 << 20;  // glibc's maximum
    ::mallopt(M_ARENA_MAX, 1);
    ::mallopt(M_MMAP_THRESHOLD, largest_in_heap);
    ::mallopt(M_TRIM_THRESHOLD, at_once + at_once / 4);
    ::mallopt(M_TOP_PAD, at_once);
    const auto before = reinterpret_cast<std::uintptr_t>(::sbrk(0));
    void* volatile grows = std::malloc(std::size_t{1} << 20);  // volatile: not optimized away
    std::free(grows);
    const auto after = reinterpret_cast<std::uintptr_t>(::sbrk(0));
    constexpr std::uintptr_t page = 2 << 20;
    const std::uintptr_t first = (before + page - 1) / page * page;
    if (after > first) ::madvise(reinterpret_cast<void*>(first), after - first, MADV_HUGEPAGE);
#endif
}

}  // namespace vantage
