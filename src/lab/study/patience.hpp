#pragma once

#include "core/watching.hpp"

#include <chrono>
#include <exception>

namespace steplab {

/// A run that takes much longer than runs may is not waited for: a step of an implicit method may take seconds.
class PatienceEnds : public std::exception {};

/// Ends what is computed on this thread in so many seconds, by PatienceEnds.
class Patience {
public:
    explicit Patience(double seconds)
        : watching_([end = Clock::now() + std::chrono::duration<double>(seconds)] {
              if (Clock::now() > end) throw PatienceEnds();
          }) {}

private:
    using Clock = std::chrono::steady_clock;
    Watching watching_;
};

}  // namespace steplab
