#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace steplab {

/// "[#######-------]  48 %  12 s left": the part of a long computation that is done, and the time left, which is not
/// known before some is done.
std::string progress_text(double fraction, double elapsed_seconds);

/// "steplab report: 48 %, 12 s left", a line for standard error where that is no terminal.
std::string progress_line(const std::string& program, double fraction, double elapsed_seconds);

/// A progress bar on standard error: from the first second on, cleared at the end.
class Progress {
public:
    /// `visible`: standard error is a terminal that nothing else writes to. If false, nothing is shown; but if it is no
    /// terminal and a program is named, a line every few seconds.
    Progress(std::uint64_t total, bool visible, std::string program = {},
             std::chrono::milliseconds between_lines = std::chrono::seconds(5));
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` of `total` is done. Costs almost nothing between two redraws.
    void at(std::uint64_t done);
    /// The same by the part that is done, 0 to 1.
    void at_part(double part);
    /// Shows a text instead, where the total is not known.
    void stage(const std::string& text);
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool is_due();
    void draw(const std::string& line);
    void print_line(const std::string& line);

    std::uint64_t total_;
    bool visible_;
    std::string program_;  ///< of lines; empty: none
    std::chrono::milliseconds between_lines_;
    bool drawn_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_ + std::chrono::seconds(1);
};

}  // namespace steplab
