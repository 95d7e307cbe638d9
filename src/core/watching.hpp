#pragma once

#include <functional>

namespace steplab {

/// While it lives, check_interruption() on this thread calls this too, every few milliseconds of a long computation: to
/// show how far it is, or to end it by an exception. One within another takes its place.
class Watching {
public:
    explicit Watching(std::function<void()> watch);
    ~Watching();
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;

private:
    std::function<void()> watch_;
    const std::function<void()>* outer_;
};

}  // namespace steplab
