// How long a window takes to answer: moves the pointer to a place and away from it, and waits until the square of SIDE
// pixels whose corner is at PIXEL_X, PIXEL_Y has changed. Not a test: the numbers depend on the machine. Used by
// window.sh.
//
//     window_latency X Y AWAY_X AWAY_Y PIXEL_X PIXEL_Y SIDE ROUNDS

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
    std::vector<unsigned long> pixels(Point corner, int side) const {
        const auto length = static_cast<unsigned>(side);
        XImage* image =
            XGetImage(display_, DefaultRootWindow(display_), corner.x, corner.y, length, length, AllPlanes, ZPixmap);
        std::vector<unsigned long> values;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) values.push_back(XGetPixel(image, x, y));
        }
        XDestroyImage(image);
        return values;
    }

private:
    Display* display_;
};

/// Milliseconds from moving the pointer until the pixels are others; negative if they stay for five seconds.
double answer_time(const Desktop& screen, Point to, Point watched, int side) {
    const std::vector<unsigned long> before = screen.pixels(watched, side);
    const auto begin = Clock::now();
    screen.move_pointer(to);
    while (Clock::now() - begin < std::chrono::seconds(5)) {
        if (screen.pixels(watched, side) != before) {
            return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
        }
        // Uncounted without a pause would take the processor from the window it looks at.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return -1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 9) {
        std::fputs("usage: window_latency X Y AWAY_X AWAY_Y PIXEL_X PIXEL_Y SIDE ROUNDS\n", stderr);
        return 2;
    }
    const auto number = [&](int i) { return std::atoi(argv[i]); };
    const Point widget{number(1), number(2)};
    const Point away{number(3), number(4)};
    const Point watched{number(5), number(6)};
    const Desktop screen;
    std::vector<double> times;
    for (int round = 0; round < number(8); ++round) {
        for (const Point to : {widget, away}) times.push_back(answer_time(screen, to, watched, number(7)));
    }
    std::sort(times.begin(), times.end());
    const auto part = [&](double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    std::printf("answers: median %.1f ms, 95 %% within %.1f ms, slowest %.1f ms, unanswered %td\n", part(0.5),
                part(0.95), times.back(), std::count_if(times.begin(), times.end(), [](double t) { return t < 0; }));
    return 0;
}
