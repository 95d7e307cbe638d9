#include "sim/run/opening.hpp"

#include "core/error.hpp"
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

RunDescription reloaded(const RunDescription& now, RunDescription fresh) {
    const RunDescription opened = describe(now.origin);
    if (now.method != opened.method || !(now.method_parameters == opened.method_parameters)) {
        fresh.method = now.method;
        fresh.method_parameters = now.method_parameters;
    }
    if (now.dt != opened.dt) fresh.dt = now.dt;
    if (now.precision != opened.precision) fresh.precision = now.precision;
    for (const ParameterInfo& info : now.scene.infos()) {
        const double value = now.scene[info.name];
        if (value == opened.scene[info.name] || !fresh.scene.contains(info.name)) continue;
        try {
            fresh.scene.set(info.name, value);
        } catch (const UsageError&) {
            continue;  // the parameter is of another kind now
        }
    }
    return fresh;
}

}  // namespace steplab
