#include "session/run_name.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

namespace steplab {

std::string run_name(const RunDescription& run, const RunDescription& leading) {
    const bool own_steps = chooses_its_steps(run) && run.method_parameters.contains("tolerance");
    std::string name = fmt::format("{}, {}, {}", run.method,
                                   own_steps ? "tolerance " + typed(run.method_parameters["tolerance"], 3)
                                             : fmt::format("dt {} s", short_number(run.dt)),
                                   id(run.precision));
    if (run.model != leading.model || run.origin != leading.origin) return name;
    for (const ParameterInfo& info : run.scene.infos()) {
        if (run.scene[info.name] != leading.scene[info.name])
            name += fmt::format(", {} {}", info.name, format_value(info, run.scene[info.name]));
    }
    return name;
}

}  // namespace steplab
