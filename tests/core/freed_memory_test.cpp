// Memory that is freed goes back to the system, but not what the next frame of a window takes again.
#include "core/freed_memory.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <sys/resource.h>
#include <vector>

// A sanitizer has memory of its own.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace steplab::test {
namespace {

/// How often the system had to provide a page for this process.
long page_faults() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

/// Takes, uses and frees so many bytes in blocks of 512 KiB.
void use_memory(std::size_t bytes) {
    constexpr std::size_t block = std::size_t{1} << 19;
    std::vector<std::unique_ptr<std::byte[]>> all;
    for (std::size_t taken = 0; taken < bytes; taken += block) all.push_back(std::make_unique<std::byte[]>(block));
}

long page_faults_of_a_second_use(std::size_t bytes) {
    use_memory(bytes);
    const long before = page_faults();
    use_memory(bytes);
    return page_faults() - before;
}

TEST(FreedMemory, is_there_for_the_next_frame_unless_it_is_much) {
    keep_no_freed_memory();
    constexpr std::size_t of_a_frame = std::size_t{12} << 20, much = std::size_t{96} << 20;
    const auto pages = static_cast<long>(much / 4096);
    EXPECT_LT(page_faults_of_a_second_use(of_a_frame), 100);
    EXPECT_GT(page_faults_of_a_second_use(much), pages / 2) << "it went back to the system";
}

}  // namespace
}  // namespace steplab::test

#endif
