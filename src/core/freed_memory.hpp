#pragma once

namespace steplab {

/// Memory that is freed goes back to the system from now on, where the C library can be told so; to be called before
/// there are threads.
void keep_no_freed_memory();

/// What was freed until now goes back, also the holes between what is still used: after much was given up at once.
/// Takes some milliseconds.
void give_back_freed_memory();

}  // namespace steplab
