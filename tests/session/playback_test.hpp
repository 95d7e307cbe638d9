#pragma once

#include "io/trajectories.hpp"
#include "session/playback.hpp"
#include "support/runs.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {

inline RunDescription played_chain(double dt = 0.1) { return run_of("chain", "rk4", Precision::double_, dt); }

/// Every second step of a run, in chunks of a few frames each, and what the run measured there.
struct Written {
    explicit Written(RunDescription description, std::size_t count = 24) : run(std::move(description)) {
        OutputFile file(path);
        TrajectoryWriter writer(file, TrajectoryFormat::trajectory, run, {});
        Simulation simulation(run);
        for (std::size_t i = 0; i < count; ++i) {
            Frame& frame = frames.emplace_back();
            simulation.frame(frame, {.displacements = true});
            measured.push_back(simulation.diagnostics());
            writer.add(frame);
            if (i % 5 == 4) writer.flush();
            simulation.advance(2);
        }
        writer.finish();
        file.commit();
    }

    TemporaryFolder folder;
    std::string path = folder.file("a.trajectory");
    RunDescription run;
    std::vector<Frame> frames;
    std::vector<Diagnostics> measured;
};

inline SessionView view_of(Playback& playback) {
    SessionView view;
    playback.observe(view);
    return view;
}

/// Position of the frame with this number among those of a file.
inline void go_to(Playback& playback, std::size_t number) {
    playback.handle(event::Step{static_cast<std::int64_t>(number) - static_cast<std::int64_t>(playback.number())});
}

}  // namespace steplab::test
