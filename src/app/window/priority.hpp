#pragma once

namespace steplab {

/// What a thread does.
enum class ThreadWork {
    pictures,  ///< after the panels, but before the runs, so that the camera follows the pointer while they play
    runs       ///< the runs and all that is computed of them
};

/// Lowers the priority of the calling thread, and of those that it starts from then on: the thread of the window, and
/// the rasteriser of its panels, go before it.
void lower_priority(ThreadWork work);

}  // namespace steplab
