#pragma once

#include <atomic>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace steplab {

/// Threads that work side by side on this machine; at least one.
std::size_t processors();

/// Where so many threads wait for each other, over and over: awake for a moment, as to be woken takes longer than some
/// steps of a large scene (std::barrier sleeps at once), then asleep.
class Rendezvous {
public:
    explicit Rendezvous(std::size_t members) : members_(members) {}
    /// So many come from now on, not fewer than are here.
    void expect(std::size_t members) { members_ = members; }
    /// Nobody goes on before all are here.
    void wait();

private:
    std::atomic<std::size_t> members_;
    std::atomic<std::size_t> arrived_ = 0;
    std::atomic<std::uint32_t> round_ = 0;
};

/// Some threads, the caller's among them, that do the same work side by side. They sleep between.
class Team {
public:
    /// The caller alone where fewer than two are asked for. Throws std::system_error if there are no threads to be had.
    explicit Team(std::size_t members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// work(i) for every member i, which must not throw; back when all are done. All compute in the floating-point mode
    /// of the caller (FlushSubnormals).
    void run(const std::function<void(std::size_t)>& work);
    /// Called by all members within their work: nobody goes on before all are here.
    void meet();
    std::size_t members() const { return members_; }
    /// What of `count` things is a member's, if each has as many.
    struct Part {
        std::size_t begin, end;
    };
    Part part(std::size_t count, std::size_t member) const {
        return {count * member / members_, count * (member + 1) / members_};
    }

    /// f(i) for each i below `count`, by whoever is free. Once one has thrown, no further one is begun, and the first
    /// exception is thrown on.
    void share(std::size_t count, const std::function<void(std::size_t)>& f);

private:
    void serve(std::size_t member);
    void dismiss();

    std::size_t members_;
    Rendezvous meeting_;
    std::fenv_t mode_{};
    const std::function<void(std::size_t)>* work_ = nullptr;  ///< null: it is time to go home
    std::vector<std::jthread> others_;
};

}  // namespace steplab
