#pragma once

#include <atomic>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace steplab {

/// Number of threads that this machine runs in parallel; at least 1.
std::size_t processors();

/// A reusable barrier for a number of threads. A waiting thread stays awake for a moment, because waking it takes
/// longer than some steps of a large scene, and then sleeps (std::barrier sleeps at once).
class Rendezvous {
public:
    explicit Rendezvous(std::size_t members) : members_(members) {}
    /// Changes the number of threads to wait for; not to fewer than are waiting already.
    void expect(std::size_t members) { members_ = members; }
    /// Returns when all threads have called it.
    void wait();

private:
    std::atomic<std::size_t> members_;
    std::atomic<std::size_t> arrived_ = 0;
    std::atomic<std::uint32_t> round_ = 0;
};

/// A team of threads, including the caller's, that do the same work in parallel. They sleep between two runs.
class Team {
public:
    /// The caller alone if `members` is less than 2. Fewer members where the system does not grant as many threads.
    explicit Team(std::size_t members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// Runs work(i) for every member i, which must not throw, and returns when all have finished. All compute in the
    /// caller's floating-point mode (FlushSubnormals).
    void run(const std::function<void(std::size_t)>& work);
    /// A barrier, called by all members within their work.
    void meet();
    std::size_t members() const { return members_; }
    /// The share of a member if `count` items are divided evenly.
    struct Part {
        std::size_t begin, end;
    };
    Part part(std::size_t count, std::size_t member) const {
        return {count * member / members_, count * (member + 1) / members_};
    }

    /// Runs f(i) for each i < `count`, each by the next free thread. After an exception no further call begins, and the
    /// first exception is rethrown.
    void share(std::size_t count, const std::function<void(std::size_t)>& f);

private:
    void serve(std::size_t member);
    void dismiss();

    std::size_t members_;
    Rendezvous meeting_;
    std::fenv_t mode_{};
    const std::function<void(std::size_t)>* work_ = nullptr;  ///< null: the threads end
    std::vector<std::jthread> others_;
};

}  // namespace steplab
