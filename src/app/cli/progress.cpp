#include "app/cli/progress.hpp"

#include "core/clamped.hpp"
#include "core/duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace steplab {

namespace {

/// "12 s left" after this text; empty while the time is not known.
std::string time_left(const char* before, double fraction, double elapsed_seconds) {
    if (!(fraction > 0)) return {};
    return fmt::format("{}{} left", before, duration_text(std::ceil(elapsed_seconds * (1 - fraction) / fraction)));
}

}  // namespace

std::string progress_text(double fraction, double elapsed_seconds) {
    constexpr int width = 30;
    const int filled = clamped_floor(fraction * width, 0, width);
    return fmt::format("[{}{}] {:3.0f} %{}", std::string(static_cast<std::size_t>(filled), '#'),
                       std::string(static_cast<std::size_t>(width - filled), '-'), std::floor(fraction * 100),
                       time_left("  ", fraction, elapsed_seconds));
}

std::string progress_line(const std::string& program, double fraction, double elapsed_seconds) {
    return fmt::format("{}: {:.0f} %{}\n", program, std::floor(fraction * 100),
                       time_left(", ", fraction, elapsed_seconds));
}

Progress::Progress(std::uint64_t total, bool visible, std::string program, std::chrono::milliseconds between_lines)
    : total_(total),
      visible_(visible),
      program_(visible ? std::string() : std::move(program)),
      between_lines_(between_lines) {
    if (!program_.empty()) next_ = begin_ + between_lines_;
}

Progress::~Progress() { clear(); }

bool Progress::is_due() { return (visible_ || !program_.empty()) && Clock::now() >= next_; }

void Progress::draw(const std::string& line) {
    next_ = Clock::now() + std::chrono::milliseconds(100);
    drawn_ = true;
    std::fputs(fmt::format("\r{}\x1b[K", line).c_str(), stderr);
    std::fflush(stderr);
}

void Progress::print_line(const std::string& line) {
    next_ = Clock::now() + between_lines_;
    std::fputs(line.c_str(), stderr);
}

void Progress::at(std::uint64_t done) {
    at_part(total_ > 0 ? static_cast<double>(done) / static_cast<double>(total_) : 1);
}

void Progress::at_part(double part) {
    if (!is_due()) return;
    const double fraction = part > 0 ? std::min(part, 1.0) : 0;
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    visible_ ? draw(progress_text(fraction, elapsed)) : print_line(progress_line(program_, fraction, elapsed));
}

void Progress::stage(const std::string& text) {
    if (is_due()) visible_ ? draw(text) : print_line(program_ + ": " + text + '\n');
    begin_ = Clock::now();
}

void Progress::clear() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

}  // namespace steplab
