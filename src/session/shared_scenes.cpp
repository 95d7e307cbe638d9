#include "session/shared_scenes.hpp"

#include <utility>
#include <variant>

namespace steplab {

namespace {

/// The same run, of a scene of equal content.
RunDescription with_origin(RunDescription run, const SceneOrigin& origin) {
    ParameterValues scene(origin->model->info.parameters);
    for (const ParameterInfo& info : run.scene.infos()) scene.set(info.name, run.scene[info.name]);
    const auto altered = run.alterations.all();
    run.alterations = Alterations(*origin->model, origin, {altered.begin(), altered.end()});
    run.scene = std::move(scene);
    run.origin = origin;
    return run;
}

}  // namespace

void SharedScenes::share(RunDescription& run) {
    if (!run.origin) return;
    const SceneOrigin first = first_of(run.origin);
    if (&*first != &*run.origin) run = with_origin(std::move(run), first);
}

void SharedScenes::share(Recording& recording) {
    share(recording.start);
    const auto share_run = [this](auto& event) {
        if constexpr (requires { event.description; }) share(event.description);
    };
    for (RecordedEvent& recorded : recording.events) std::visit(share_run, recorded.event);
}

SceneOrigin SharedScenes::first_of(const SceneOrigin& read) {
    std::erase_if(known_, [](const auto& scene) { return scene.expired(); });
    for (const auto& scene : known_) {
        SceneOrigin known(scene.lock());
        if (known && known == read && known->given == read->given) return known;
    }
    known_.push_back(read.watched());
    return read;
}

}  // namespace steplab
