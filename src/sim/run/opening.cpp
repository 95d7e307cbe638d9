#include "sim/run/opening.hpp"

#include "core/ticks.hpp"
#include "sim/catalogue.hpp"

namespace steplab {

double opening_dt(const RunDescription& scene) {
    const double dt = model_of(scene).opening.dt;
    if (scene.origin) return dt;  // a file says what suits it
    const double usual = fastest_frequency(with_model(scene, scene.model)), here = fastest_frequency(scene);
    return here > usual && usual > 0 ? nice_floor(dt * usual / here) : dt;
}

RunDescription opening(RunDescription scene) {
    scene = with_method(scene, model_of(scene).opening.method);
    scene.dt = opening_dt(scene);
    return scene;
}

}  // namespace steplab
