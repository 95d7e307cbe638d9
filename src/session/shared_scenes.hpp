#pragma once

#include "models/scene_origin.hpp"
#include "session/recording.hpp"
#include "sim/run/run_description.hpp"

#include <memory>
#include <vector>

namespace steplab {

/// Scene files of equal content and name that are read several times share what the first reading made of them, for as
/// long as it is in use: a recording keeps the scene of each of its events.
class SharedScenes {
public:
    void share(RunDescription& run);
    /// Its start and all runs of its events.
    void share(Recording& recording);

private:
    SceneOrigin first_of(const SceneOrigin& read);

    std::vector<std::weak_ptr<const SceneFile>> known_;
};

}  // namespace steplab
