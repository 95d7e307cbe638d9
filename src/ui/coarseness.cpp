#include "ui/coarseness.hpp"

#include <bit>

namespace steplab::ui {
namespace {

// A quarter of the pixels takes at least a quarter of the time, and as a rule not much more.
constexpr double gain = 3;
// A full picture that takes so many times as long or as short is of another scene or view.
constexpr double other_scene = 2;

std::size_t level_of(int enlarged) {
    return static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(enlarged)));
}

}  // namespace

void Coarseness::took(int enlarged, double seconds) {
    double& known = seconds_[level_of(enlarged)];
    const bool other = seconds > other_scene * known || other_scene * seconds < known;
    if (enlarged == 1 && other) seconds_.fill(0);
    known = seconds;
}

double Coarseness::expected(std::size_t level) const {
    if (level == 0 || seconds_[level] > 0) return seconds_[level];
    return expected(level - 1) / gain;
}

int Coarseness::next(bool camera_moves) const {
    std::size_t level = 0;
    while (camera_moves && level + 1 < levels && expected(level) > enough) ++level;
    return 1 << level;
}

}  // namespace steplab::ui
