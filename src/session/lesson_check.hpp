#pragma once

#include "session/lesson.hpp"

#include <cstddef>
#include <vector>

namespace steplab {

/// A fact of a lesson beside what its session computes.
struct CheckedFact {
    std::size_t page = 0;  ///< counted from 0
    LessonFact fact;
    double value = 0;  ///< not a number where it is not known

    bool holds() const { return value >= fact.least && value <= fact.most; }
};

/// Computes the session of a lesson and measures what its pages state. Throws UsageError where the session differs from
/// what was recorded, Interrupted.
std::vector<CheckedFact> check_facts(const Lesson& lesson);

}  // namespace steplab
