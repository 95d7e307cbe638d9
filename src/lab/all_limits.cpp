#include "lab/all_limits.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace steplab {

namespace {

Limit limit_or_refusal(const StabilityLab& lab, const RunDescription& run) {
    try {
        return lab.limit(run);
    } catch (const UsageError& refusal) {
        return {.description = run, .omega_max = lab.omega_max(), .theory = {}, .measured = {}, .note = refusal.what()};
    }
}

/// Hands out the methods to threads.
class Work {
public:
    Work(const StabilityLab& lab, std::span<const RunDescription> methods, const std::function<void(std::size_t)>& done)
        : lab_(lab), methods_(methods), done_(done), limits_(methods.size()) {}

    std::vector<Limit> limits() {
        {
            const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
            std::vector<std::jthread> others;
            for (std::size_t i = 1; i < std::min(most, methods_.size()); ++i) others.emplace_back([this] { serve(); });
            serve();
        }
        if (failure_) std::rethrow_exception(failure_);
        return std::move(limits_);
    }

private:
    void serve() {
        try {
            for (std::size_t i = next_++; i < methods_.size() && !stopped_; i = next_++) {
                limits_[i] = limit_or_refusal(lab_, methods_[i]);
                const std::lock_guard lock(mutex_);
                done_(++found_);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!stopped_) failure_ = std::current_exception();
            stopped_ = true;
        }
    }

    const StabilityLab& lab_;
    std::span<const RunDescription> methods_;
    const std::function<void(std::size_t)>& done_;
    std::vector<Limit> limits_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stopped_ = false;
    std::mutex mutex_;  ///< of what follows
    std::size_t found_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

std::vector<Limit> all_limits(const StabilityLab& lab, std::span<const RunDescription> methods,
                              const std::function<void(std::size_t)>& done) {
    return Work(lab, methods, done).limits();
}

}  // namespace steplab
