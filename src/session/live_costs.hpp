#pragma once

#include "lab/study/cost_scan.hpp"
#include "session/session_view.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace steplab {

/// What accuracy costs on the scene of these runs, the leading one first, and the runs themselves: all of it at once,
/// which takes some seconds. Throws UsageError, Interrupted.
CostsView costs_of(const std::vector<RunDescription>& runs);

/// Scans what accuracy costs on the scene of a session, on a thread of its own and as far as the runs leave it time.
class LiveCosts {
public:
    /// `ready` is called from the thread when there is more to see.
    explicit LiveCosts(std::function<void()> ready);
    ~LiveCosts();

    /// Of the scene of these runs, the leading one first, and of the runs themselves. Goes on if the scene is that of
    /// before; else what was known is forgotten.
    void ask(std::vector<RunDescription> runs);
    /// What is known of what was asked last; null before the first point.
    std::shared_ptr<const CostsView> newest() const;
    /// Nothing is wanted any more.
    void forget();

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
