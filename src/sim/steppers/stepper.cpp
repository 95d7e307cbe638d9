#include "sim/steppers/stepper.hpp"

namespace steplab {

void Stepper::synchronised(State<double>& out) const {
    if (out.displacement.count() != particles()) out = {Field<double>(particles()), Field<double>(particles())};
    emit([&](const Portion& portion) {
        copy(portion.state.displacement, portion.place, portion.count, out.displacement, portion.first);
        copy(portion.state.velocity, portion.place, portion.count, out.velocity, portion.first);
    });
}

}  // namespace steplab
