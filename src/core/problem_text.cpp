#include "core/problem_text.hpp"

#include <new>

namespace steplab {

std::string problem_text(const std::exception& problem) noexcept {
    const bool no_memory = dynamic_cast<const std::bad_alloc*>(&problem) != nullptr;
    return copy_or_short(no_memory ? "out of memory" : problem.what());
}

}  // namespace steplab
