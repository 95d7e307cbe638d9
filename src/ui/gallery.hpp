#pragma once

#include "session/lesson.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::ui {

/// A scene of the page of scenes: a model of the catalogue, or a shipped scene.
struct Exhibit {
    std::string id;  ///< of the model, or the name of the scene
    std::string name, what, topic;
    bool is_model = true;
    std::uint32_t picture = 0;  ///< name of its OpenGL texture; 0: none
};

/// All of them in the order of the page: topic by topic, models first.
using Gallery = std::vector<Exhibit>;

/// The models alone: what can be offered without reading a file.
Gallery model_gallery();
/// With the shipped scenes, whose files are read. One that cannot be read is left out.
Gallery whole_gallery();

/// The place of a scene; the size of the gallery if it is not in there.
std::size_t place_in(const Gallery& gallery, std::string_view id);
/// What stands for the scene of a run: the id of its model, or what names its file.
std::string_view id_of(const RunDescription& run);

/// The lessons that come with the program, whose files are read. One that cannot be read is left out.
std::vector<LessonTitle> lesson_titles();

}  // namespace steplab::ui
