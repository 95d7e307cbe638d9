#pragma once

#include <cstddef>

namespace steplab::test {

/// How often anybody has asked for memory so far.
std::size_t allocations();

/// As long as it lives, there is no memory for anything larger than so many bytes, whoever asks.
struct NoLargerThan {
    explicit NoLargerThan(std::size_t bytes);
    ~NoLargerThan();
    NoLargerThan(const NoLargerThan&) = delete;
    NoLargerThan& operator=(const NoLargerThan&) = delete;
};

/// As long as it lives, there is memory for this thread alone.
struct NoMemoryElsewhere {
    NoMemoryElsewhere();
    ~NoMemoryElsewhere();
    NoMemoryElsewhere(const NoMemoryElsewhere&) = delete;
    NoMemoryElsewhere& operator=(const NoMemoryElsewhere&) = delete;
};

}  // namespace steplab::test
