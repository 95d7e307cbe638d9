#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace steplab {

/// "[#######-------]  48 %  12 s left": how far a long piece of work is and how long it will take. The text alone.
std::string progress_text(double fraction, double elapsed_seconds);

/// Shows it on standard error while work goes on, from the first second, if a person looks on; cleared at the end.
class Progress {
public:
    /// `watched`: standard error is a terminal that nothing else writes to.
    Progress(std::uint64_t total, bool watched);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// So much is done; costs nothing between two redraws.
    void at(std::uint64_t done);
    /// The same for work of which nobody knows how much there is: what is going on.
    void say(const std::string& what);
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool is_due();
    void draw(const std::string& line);

    std::uint64_t total_;
    bool watched_;
    bool drawn_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_ + std::chrono::seconds(1);
};

}  // namespace steplab
