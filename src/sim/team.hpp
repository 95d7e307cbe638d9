#pragma once

#include <barrier>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace steplab {

/// Some threads, the caller's among them, that do the same work side by side. They sleep between.
class Team {
public:
    explicit Team(std::size_t members);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// work(i) for every member i, which must not throw; back when all are done. Subnormals are flushed as where a run
    /// is stepped (FlushSubnormals).
    void run(const std::function<void(std::size_t)>& work);
    /// Called by all members within their work: nobody goes on before all are here.
    void meet() { meeting_.arrive_and_wait(); }

private:
    void serve(std::size_t member);

    std::barrier<> meeting_;
    const std::function<void(std::size_t)>* work_ = nullptr;  ///< null: it is time to go home
    std::vector<std::jthread> others_;
};

}  // namespace steplab
