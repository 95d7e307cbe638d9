#include "ui/gallery.hpp"

#include "core/appearance.hpp"
#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "io/shared_files.hpp"
#include "sim/catalogue.hpp"

#include <algorithm>
#include <utility>

namespace steplab::ui {
namespace {

Exhibit exhibit_of(const Model& model, std::string id, bool is_model) {
    return {.id = std::move(id),
            .name = std::string(model.info.name),
            .what = std::string(model.info.what),
            .topic = std::string(model.topic),
            .is_model = is_model};
}

auto rank(const Exhibit& exhibit) {
    return std::find(topic_ids.begin(), topic_ids.end(), exhibit.topic) - topic_ids.begin();
}

Gallery sorted(Gallery gallery) {
    std::stable_sort(gallery.begin(), gallery.end(),
                     [](const Exhibit& a, const Exhibit& b) { return rank(a) < rank(b); });
    return gallery;
}

}  // namespace

Gallery model_gallery() {
    Gallery gallery;
    for (const Model& model : models()) gallery.push_back(exhibit_of(model, std::string(model.info.id), true));
    return sorted(std::move(gallery));
}

Gallery whole_gallery() {
    Gallery gallery = model_gallery();
    for (const std::string& name : shipped_scenes()) {
        if (place_in(gallery, name) < gallery.size()) continue;  // a model written as a file
        try {
            gallery.push_back(exhibit_of(*find_scene(name)->model, name, false));
        } catch (const Error&) {
            continue;  // whoever opens it by its name is told what is wrong
        }
    }
    return sorted(std::move(gallery));
}

std::vector<LessonTitle> lesson_titles() {
    std::vector<LessonTitle> titles;
    for (const std::string& name : shared_names("lessons", ".toml")) {
        try {
            titles.push_back(title_of(find_lesson(name)));
        } catch (const Error&) {
            continue;  // as above
        }
    }
    std::stable_sort(titles.begin(), titles.end(),
                     [](const LessonTitle& a, const LessonTitle& b) { return a.order < b.order; });
    return titles;
}

std::size_t place_in(const Gallery& gallery, std::string_view id) {
    const auto found = std::find_if(gallery.begin(), gallery.end(), [&](const Exhibit& e) { return e.id == id; });
    return static_cast<std::size_t>(found - gallery.begin());
}

std::string_view id_of(const RunDescription& run) { return run.origin ? run.origin->given : run.model; }

}  // namespace steplab::ui
