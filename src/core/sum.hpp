#pragma once

#include <cmath>

namespace steplab {

/// Adds doubles and carries what rounding drops along (Neumaier, Z. Angew. Math. Mech. 54 (1974) 39), so that energies
/// of a million particles keep their digits. Numbers are added in the order given.
class CompensatedSum {
public:
    void add(double term) {
        const double next = sum_ + term;
        correction_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    /// Not finite if a term was not.
    double value() const { return std::isfinite(correction_) ? sum_ + correction_ : sum_; }

private:
    double sum_ = 0;
    double correction_ = 0;
};

}  // namespace steplab
