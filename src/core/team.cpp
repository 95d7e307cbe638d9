#include "core/team.hpp"

#include "core/interruption.hpp"
#include "core/interruption_of_thread.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>

namespace steplab {

std::size_t processors() { return std::max(1U, std::thread::hardware_concurrency()); }

void Rendezvous::wait() {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::microseconds awake{100};  // about as long as waking a thread takes
    const std::uint32_t round = round_;
    if (++arrived_ == members_) {
        arrived_ = 0;
        ++round_;
        return round_.notify_all();
    }
    // a thread that the others wait for may need this processor
    for (const auto end = Clock::now() + awake; round_ == round && Clock::now() < end;) std::this_thread::yield();
    round_.wait(round);
}

Team::Team(std::size_t members) : members_(std::max<std::size_t>(1, members)), meeting_(members_) {
    try {
        others_.reserve(members_ - 1);
        for (std::size_t member = 1; member < members_; ++member) {
            others_.emplace_back([this, member] { serve(member); });
        }
    } catch (const std::exception&) {
        members_ = others_.size() + 1;
        meeting_.expect(members_);
    }
}

Team::~Team() { dismiss(); }

void Team::dismiss() {
    work_ = nullptr;
    meet();
}

void Team::meet() {
    if (members_ > 1) meeting_.wait();
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
    const std::atomic<bool>* const asked = interruption_of_this_thread();
    run([&](std::size_t member) {
        std::optional<InterruptibleBy> interruptible;
        if (asked && member > 0) interruptible.emplace(*asked);
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

/// Before the first meeting the number of members may still change, so it is not read.
void Team::serve(std::size_t member) {
    while (true) {
        meeting_.wait();
        if (!work_) return;
        std::fesetenv(&mode_);
        (*work_)(member);
        meeting_.wait();
    }
}

}  // namespace steplab
