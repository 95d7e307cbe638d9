#pragma once

#include "core/lanes.hpp"
#include "core/sum.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/morse_pair.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace steplab {

/// Sums the energies of pairs from their squared distances. They are computed and summed in SIMD lanes, as many as a
/// cache line has numbers on every machine.
template <class T, class Constants>
class MorseEnergies {
public:
    explicit MorseEnergies(const Constants& morse) : morse_(constants_as<Many>(morse)) {}

    void add(const T& distance2) {
        squares_[held_++] = distance2;
        if (held_ == most) finish();
    }
    /// The energy of all pairs, and the sum of the magnitudes of its terms.
    PotentialEnergy sum() {
        finish();
        return {value_.value(), magnitude_.value(), 0};
    }

private:
    using Many = CacheLineLanes<T>;
    static constexpr std::size_t most = 64 * Many::count;

    void finish() {
        for (std::size_t k = 0; k < held_; k += Many::count) {
            const Many energy =
                where(Many::first(held_ - k), morse_energy(morse_, square_root(Many::load(&squares_[k]))), Many(T(0)));
            value_.add(energy);
            magnitude_.add(magnitude(energy));
        }
        held_ = 0;
    }

    decltype(constants_as<Many>(std::declval<const Constants&>())) morse_;
    alignas(64) std::array<T, most> squares_{};
    std::size_t held_ = 0;
    LanesSum<Many> value_, magnitude_;
};

}  // namespace steplab
