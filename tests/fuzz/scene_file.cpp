// Scene files of any content: each is read or refused, and what is read can be planned.

#include "io/scene_file.hpp"

#include "core/error.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace steplab;
    try {
        const std::string text(reinterpret_cast<const char*>(data), size);
        const RunDescription run = describe(scene_from({{.name = "", .content = text}}, "a.toml"));
        check_values(run);
        const Model& scene = model_of(run);
        if (scene.particles(run.scene) <= 1000) scene.plan(run.scene), scene.shape(run.scene);
    } catch (const Error&) {  // all that may come out of it
    }
    return 0;
}
