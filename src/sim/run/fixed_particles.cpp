#include "sim/run/fixed_particles.hpp"

#include <variant>

namespace steplab {

namespace {

struct IsFixed {
    std::size_t i;

    bool operator()(const LineForces& line) const { return line.first_fixed && i == 0; }
    bool operator()(const GridForces& grid) const {
        const std::size_t row = i / grid.columns, column = i % grid.columns;
        return row == 0 || column == 0 || row + 1 == grid.rows || column + 1 == grid.columns;
    }
    bool operator()(const ComposedForces& forces) const {
        return !forces.terms->fixed.empty() && forces.terms->fixed[i] != 0;
    }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
};

}  // namespace

bool is_fixed(const Forces& forces, std::size_t particle) { return std::visit(IsFixed{particle}, forces); }

}  // namespace steplab
