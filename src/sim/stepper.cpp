#include "sim/stepper.hpp"

#include <algorithm>

namespace steplab {

void Stepper::synchronised(State<double>& out) const {
    if (out.displacement.count() != particles()) out = {Field<double>(particles()), Field<double>(particles())};
    look([&](const Portion& portion) {
        const auto copy = [&](const Field<double>& from, Field<double>& to) {
            std::copy_n(from.x() + portion.place, portion.count, to.x() + portion.first);
            std::copy_n(from.y() + portion.place, portion.count, to.y() + portion.first);
            std::copy_n(from.z() + portion.place, portion.count, to.z() + portion.first);
        };
        copy(portion.state.displacement, out.displacement);
        copy(portion.state.velocity, out.velocity);
    });
}

}  // namespace steplab
