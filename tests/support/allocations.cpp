#include "support/allocations.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
// operator new can reach nothing but such variables.
std::atomic<std::size_t> largest = no_limit, asked = 0;
std::atomic<bool> one_thread_alone = false;
thread_local bool is_that_thread = false;

void* allocated(std::size_t bytes, std::size_t alignment) {
    ++asked;
    const std::size_t whole = (std::max<std::size_t>(1, bytes) + alignment - 1) / alignment * alignment;
    const bool refused = bytes > largest || (one_thread_alone && !is_that_thread);
    void* const memory = refused ? nullptr : std::aligned_alloc(alignment, whole);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

// In place of those of the library, whose other ones go through these; a sanitizer's do not.
void* operator new(std::size_t bytes) { return allocated(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept try {
    return allocated(bytes, alignof(std::max_align_t));
} catch (const std::bad_alloc&) {
    return nullptr;
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocated(bytes, std::max(static_cast<std::size_t>(alignment), alignof(std::max_align_t)));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace steplab::test {

std::size_t allocations() { return asked; }

NoLargerThan::NoLargerThan(std::size_t bytes) { largest = bytes; }
NoLargerThan::~NoLargerThan() { largest = no_limit; }

NoMemoryElsewhere::NoMemoryElsewhere() {
    is_that_thread = true;
    one_thread_alone = true;
}
NoMemoryElsewhere::~NoMemoryElsewhere() {
    one_thread_alone = false;
    is_that_thread = false;
}

}  // namespace steplab::test
