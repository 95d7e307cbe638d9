#pragma once

#include <cmath>
#include <cstddef>

namespace steplab {

/// Compensated summation of doubles (Neumaier, Z. Angew. Math. Mech. 54 (1974) 39), so that energies of a million
/// particles keep their digits. Numbers are added in the order given.
class CompensatedSum {
public:
    void add(double term) {
        const double next = sum_ + term;
        correction_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    /// Not finite if any term was not.
    double value() const { return std::isfinite(correction_) ? sum_ + correction_ : sum_; }

private:
    double sum_ = 0;
    double correction_ = 0;
};

/// The same for terms in SIMD lanes: each lane has its own sum, with its rounding error after Knuth (The Art of
/// Computer Programming 2, 4.2.2, theorem B); the lanes are then added in order. Use the same number of lanes on every
/// machine.
template <class N>
class LanesSum {
public:
    [[gnu::always_inline]] void add(const N& term) {
        const N next = sum_ + term, added = next - sum_;
        correction_ = correction_ + ((sum_ - (next - added)) + (term - added));
        sum_ = next;
    }
    double value() const {
        CompensatedSum all;
        for (std::size_t lane = 0; lane < N::count; ++lane) all.add(static_cast<double>(sum_[lane]));
        for (std::size_t lane = 0; lane < N::count; ++lane) all.add(static_cast<double>(correction_[lane]));
        return all.value();
    }

private:
    N sum_{}, correction_{};
};

}  // namespace steplab
