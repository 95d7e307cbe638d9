#pragma once

namespace steplab {

/// From now on the program ends with one line and the exit code of a missing display when the X server goes away, where
/// Xlib would end it with its own message and code. On other displays nothing happens.
void answer_display_loss();

}  // namespace steplab
