#include "app/cli/progress.hpp"

#include "core/duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace steplab {

std::string progress_text(double fraction, double elapsed_seconds) {
    constexpr int width = 30;
    const int filled = std::clamp(static_cast<int>(fraction * width), 0, width);
    return fmt::format("[{}{}] {:3.0f} %  {} left", std::string(static_cast<std::size_t>(filled), '#'),
                       std::string(static_cast<std::size_t>(width - filled), '-'), std::floor(fraction * 100),
                       duration_text(std::ceil(elapsed_seconds * (1 - fraction) / fraction)));
}

Progress::Progress(std::uint64_t total, bool visible) : total_(total), visible_(visible) {}

Progress::~Progress() { clear(); }

bool Progress::is_due() { return visible_ && Clock::now() >= next_; }

void Progress::draw(const std::string& line) {
    next_ = Clock::now() + std::chrono::milliseconds(100);
    drawn_ = true;
    std::fputs(fmt::format("\r{}\x1b[K", line).c_str(), stderr);
    std::fflush(stderr);
}

void Progress::at(std::uint64_t done) {
    if (!is_due()) return;
    const double fraction = static_cast<double>(done) / static_cast<double>(total_);
    draw(progress_text(fraction, std::chrono::duration<double>(Clock::now() - begin_).count()));
}

void Progress::stage(const std::string& text) {
    if (is_due()) draw(text);
    begin_ = Clock::now();
}

void Progress::clear() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

}  // namespace steplab
