#pragma once

#include <cstddef>

namespace steplab {

/// Calls f(k) for k = 0 .. size-1, in any order and in vector registers: no call may read what another one writes.
template <class F>
inline void elementwise(std::size_t size, F f) {
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
    for (std::size_t k = 0; k < size; ++k) f(k);
}

}  // namespace steplab
