#include "app/window/display_loss.hpp"

#include "app/cli/standard_streams.hpp"
#include "core/error.hpp"
#include "core/program_end.hpp"

#include <X11/Xlib.h>

namespace steplab {

namespace {

/// Xlib ends the program when this returns. Xlib's locks are held, by any thread: nothing can be closed any more.
int end(::Display*) {
    print_aside("steplab-view: the connection to the display is lost\n");
    end_program(static_cast<int>(ExitCode::no_opengl));
}

}  // namespace

void answer_display_loss() { XSetIOErrorHandler(end); }

}  // namespace steplab
