#pragma once

namespace steplab {

/// Lowers the priority of this thread, and of threads it starts, below that of the thread that answers the user.
void lower_priority();

}  // namespace steplab
