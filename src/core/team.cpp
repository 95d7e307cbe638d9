#include "core/team.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace steplab {

std::size_t processors() { return std::max(1U, std::thread::hardware_concurrency()); }

Team::Team(std::size_t members)
    : members_(std::max<std::size_t>(1, members)), meeting_(static_cast<std::ptrdiff_t>(members_)) {
    try {
        for (std::size_t member = 1; member < members_; ++member) {
            others_.emplace_back([this, member] { serve(member); });
        }
    } catch (...) {
        for (std::size_t missing = others_.size() + 1; missing < members_; ++missing) meeting_.arrive_and_drop();
        dismiss();
        throw;
    }
}

Team::~Team() { dismiss(); }

void Team::dismiss() {
    work_ = nullptr;
    meet();
}

void Team::meet() {
    if (members_ > 1) meeting_.arrive_and_wait();
}

void Team::run(const std::function<void(std::size_t)>& work) {
    std::fegetenv(&mode_);
    work_ = &work;
    meet();
    work(0);
    meet();
}

void Team::share(std::size_t count, const std::function<void(std::size_t)>& f) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stopped = false;
    std::mutex mutex;
    std::exception_ptr failure;
    run([&](std::size_t) {
        try {
            for (std::size_t i = next++; i < count && !stopped; i = next++) f(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            stopped = true;
        }
    });
    if (failure) std::rethrow_exception(failure);
}

void Team::serve(std::size_t member) {
    while (true) {
        meet();
        if (!work_) return;
        std::fesetenv(&mode_);
        (*work_)(member);
        meet();
    }
}

}  // namespace steplab
