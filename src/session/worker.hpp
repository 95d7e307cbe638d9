#pragma once

#include "session/run_view.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace steplab {

/// What a person can do to a run. The interface talks to this alone; tests put a recorder in its place.
class Commands {
public:
    virtual ~Commands() = default;
    virtual void play(bool on) = 0;
    virtual void step_forward() = 0;
    virtual void step_back() = 0;
    virtual void restart() = 0;
    virtual void change(const RunDescription& description) = 0;
    virtual void set_rate(Rate rate) = 0;
    virtual void track(std::optional<std::size_t> particle) = 0;
    /// Takes a particle to a place and holds it there for this moment: without velocity, beginning a new segment.
    virtual void pull(std::size_t particle, Vec3 position) = 0;
    /// Which runs go beside the run, from its start on.
    virtual void show_ensemble(const LiveEnsembleOptions& ensemble) = 0;
    /// Whether views hold the forces on the particles.
    virtual void show_forces(bool on) = 0;
};

/// Owns a simulation on a thread of its own. Commands return at once; results are taken when there are new ones.
class Worker final : public Commands {
public:
    explicit Worker(const RunDescription& description);
    ~Worker() override;

    void play(bool on) override;
    void step_forward() override;
    void step_back() override;
    void restart() override;
    void change(const RunDescription& description) override;
    void set_rate(Rate rate) override;
    void track(std::optional<std::size_t> particle) override;
    void pull(std::size_t particle, Vec3 position) override;
    void show_ensemble(const LiveEnsembleOptions& ensemble) override;
    void show_forces(bool on) override;

    /// Takes the run forward to this step as fast as it can, unless another command of the run comes before it is
    /// there.
    void go_to(std::uint64_t step);

    /// Swaps the newest view into `view` if there is one that was not taken yet; false if nothing is new. Never waits.
    bool take(RunView& view);
    /// Why no new view comes, where steps take so long that the check of an impossible energy is some moments away.
    std::optional<Doubt> doubt() const;
    /// Called from the worker's thread when a new view or doubt is ready (to wake the window); set before the first
    /// command.
    void on_view(void (*wake)());

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
