#pragma once

#include <malloc.h>

namespace steplab::test {

/// Bytes on the heap; 0 where malloc is replaced by a sanitizer's.
inline double heap() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace steplab::test
