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

/// True if f(k) is true for a k = 0 .. size-1; f is called for all of them, in vector registers.
template <class F>
inline bool any_of_all(std::size_t size, F f) {
    unsigned found = 0;
    for (std::size_t k = 0; k < size; ++k) found |= static_cast<unsigned>(f(k));
    return found != 0;
}

}  // namespace steplab
