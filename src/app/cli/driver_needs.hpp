// What drivers of OpenGL take for granted.
#pragma once

#include "core/error.hpp"
#include "core/team.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sys/mman.h>

namespace steplab {

/// To be called before OpenGL is loaded. Mesa's software renderer waits for ever for threads that the system does not
/// grant it: where there are too few, it is told to draw on the calling thread alone. Each of its `drivers` rasterises
/// with one for each processor, and takes as many for other work if there are any left.
inline void limit_driver_threads(std::size_t drivers = 1) {
    constexpr std::size_t most = 32;  // of Mesa 22.3
    const std::size_t wanted = (2 * drivers - 1) * std::min(processors(), most) + 1;
    if (Team(wanted).members() < wanted) setenv("LP_NUM_THREADS", "0", 0);
}

/// Address space that a driver takes with its compiler and the heaps of its threads, in bytes, when it is loaded and
/// when it draws. Measured: Mesa 22.3 dies with less than 640 MB in all, drawing 1280x720 pixels.
inline constexpr std::size_t driver_space = 700'000'000, drawing_space = 250'000'000;

/// Mesa dies where memory is refused to it, so `bytes` of address space must be there beforehand. Error: UsageError.
inline void require_space_to_draw(std::size_t bytes) {
    void* const space = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (space == MAP_FAILED)
        throw UsageError(fmt::format("not enough memory to draw: that takes {} MB of address space (see ulimit -v)",
                                     bytes / 1'000'000));
    munmap(space, bytes);
}

}  // namespace steplab
