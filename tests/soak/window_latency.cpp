// How long a window takes to answer: moves the pointer onto a widget and away from it, and waits for the widget's pixel
// to change. Not a test: the numbers depend on the machine. Used by window.sh.
//
//     window_latency X Y AWAY_X AWAY_Y PIXEL_X PIXEL_Y ROUNDS

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

struct Point {
    int x = 0;
    int y = 0;
};

/// The display for as long as it is used.
class Desktop {
public:
    Desktop() : display_(XOpenDisplay(nullptr)) {
        if (display_) return;
        std::fputs("window_latency: no display\n", stderr);
        std::exit(5);
    }
    ~Desktop() { XCloseDisplay(display_); }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    void move_pointer(Point to) const {
        XWarpPointer(display_, None, DefaultRootWindow(display_), 0, 0, 0, 0, to.x, to.y);
        XSync(display_, False);
    }
    unsigned long pixel(Point at) const {
        XImage* image = XGetImage(display_, DefaultRootWindow(display_), at.x, at.y, 1, 1, AllPlanes, ZPixmap);
        const unsigned long value = XGetPixel(image, 0, 0);
        XDestroyImage(image);
        return value;
    }

private:
    Display* display_;
};

/// Milliseconds from moving the pointer until the pixel is another one; negative if it stays for five seconds.
double answer_time(const Desktop& screen, Point to, Point watched) {
    const unsigned long before = screen.pixel(watched);
    const auto begin = Clock::now();
    screen.move_pointer(to);
    while (Clock::now() - begin < std::chrono::seconds(5)) {
        if (screen.pixel(watched) != before) {
            return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
        }
        // Uncounted without a pause would take the processor from the window it looks at.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return -1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 8) {
        std::fputs("usage: window_latency X Y AWAY_X AWAY_Y PIXEL_X PIXEL_Y ROUNDS\n", stderr);
        return 2;
    }
    const auto number = [&](int i) { return std::atoi(argv[i]); };
    const Point widget{number(1), number(2)};
    const Point away{number(3), number(4)};
    const Point watched{number(5), number(6)};
    const Desktop screen;
    std::vector<double> times;
    for (int round = 0; round < number(7); ++round) {
        for (const Point to : {widget, away}) times.push_back(answer_time(screen, to, watched));
    }
    std::sort(times.begin(), times.end());
    const auto part = [&](double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    std::printf("answers: median %.1f ms, 95 %% within %.1f ms, slowest %.1f ms, unanswered %td\n", part(0.5),
                part(0.95), times.back(), std::count_if(times.begin(), times.end(), [](double t) { return t < 0; }));
    return 0;
}
