#include "core/freed_memory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace steplab {

void keep_no_freed_memory() {
#ifdef M_MMAP_THRESHOLD
    mallopt(M_MMAP_THRESHOLD, 1 << 20);   // glibc's own grows to 32 MiB, and memory freed below it leaves holes
    mallopt(M_TRIM_THRESHOLD, 32 << 20);  // drawing frees some megabytes for each frame
#endif
}

void give_back_freed_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace steplab
