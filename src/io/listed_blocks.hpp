#pragma once

#include "models/scene/scene.hpp"

namespace steplab {

/// The same scene without a file: each particle that was read from one has a block of its own, in the same order.
/// Throws UsageError, naming the file and the reason, for a scene that needs its files.
Scene without_files(Scene scene);

}  // namespace steplab
