
#include "lab/linearised.hpp"
#include "lab/speed_error.hpp"
#include "sim/catalogue.hpp"
#include "sim/simulation.hpp"

#include <cmath>
namespace steplab {
double omega_max(const RunDescription& d) {
    auto o = model(d.model).omega_max(d.scene);
    return o.value_or(6);
}
Reference reference_for(const StudyPlan& plan) {
    Reference r;
    Simulation s(run_over(plan, "kahan-li-8", Precision::double_, 1));
    const std::size_t n = s.particles();
    r.displacement = Field<double>(n);
    if (auto e = model(plan.scene.model).exact(plan.scene.scene)) {
        for (std::size_t i = 0; i < n; ++i) r.displacement.set(i, e->displacement(i, plan.time));
        r.error = 1e-15;
        r.how = "exact solution";
        return r;
    }
    std::uint64_t N = fewest_steps(plan, "kahan-li-8") * 8;
    Simulation a(run_over(plan, "kahan-li-8", Precision::double_, N)),
        b(run_over(plan, "kahan-li-8", Precision::double_, 2 * N));
    a.advance(N);
    b.advance(2 * N);
    r.displacement = b.state().displacement;
    r.how = "kahan-li-8 in double";
    for (std::size_t i = 0; i < n; ++i) r.error = std::max(r.error, r.distance(a.state().displacement, i));
    return r;
}
}  // namespace steplab
