// Drops a file onto a window as a file manager does (XDND, version 5): drop_file WINDOW PATH

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

/// The source of a drag with one file.
class Source {
public:
    Source(Display* display, Window target, const std::string& path)
        : display_(display),
          target_(target),
          window_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)),
          list_("file://" + path + "\r\n") {
        XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
    }

    void drop() {
        send("XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")));
        send("XdndPosition", 0, (400L << 16) | 300, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        wait_for("XdndStatus");
        send("XdndDrop", 0, CurrentTime);
        wait_for("XdndFinished");
    }

private:
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    void send(const char* type, long a, long b = 0, long c = 0, long d = 0) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        const long data[] = {static_cast<long>(window_), a, b, c, d};
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Answers requests for the file until the message has come.
    void wait_for(const char* type) const {
        while (true) {
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == ClientMessage && event.xclient.message_type == atom(type)) return;
            if (event.type == SelectionRequest) answer(event.xselectionrequest);
        }
    }

    void answer(const XSelectionRequestEvent& request) const {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(list_.data()), static_cast<int>(list_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_;
    Window target_, window_;
    std::string list_;
};

}  // namespace

int main(int argc, char** argv) {
    Display* const display = XOpenDisplay(nullptr);
    if (argc != 3 || !display) {
        std::fputs("drop_file WINDOW PATH, on a display\n", stderr);
        return 1;
    }
    Source(display, std::strtoul(argv[1], nullptr, 0), argv[2]).drop();
    XCloseDisplay(display);
}
