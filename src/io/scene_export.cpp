#include "io/scene_export.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/particle_files.hpp"
#include "io/starting_values_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace steplab {

namespace {

constexpr std::string_view standard_output = "-";

/// True if the file is there with this content. Throws FileError if it has another one.
bool holds(const std::string& name, const std::string& content) {
    std::error_code error;
    if (!std::filesystem::exists(name, error)) return false;
    const InputFile file(name);
    if (file.size() == content.size() && file.read(0, file.size()) == content) return true;
    throw FileError(fmt::format("'{}', which the scene reads, is there with other content", shown(name)));
}

/// True if the folder has this file, and a scene there reads the same from it: of a trajectory the same moment, of a
/// compressed file the same text.
bool reads_there(const std::filesystem::path& folder, const SceneFile::Part& part, ParticleFiles::Use use) {
    try {
        return ParticleFiles::text_in(folder, ParticleFiles::name_below(part.name), use) == part.content;
    } catch (const FileError&) {
        return false;
    }
}

/// Nothing that is there is written over: it may be what the scene was made from.
void write_beside(const std::filesystem::path& folder, const std::string& name, const std::string& content) {
    const std::filesystem::path path = folder / name;
    if (holds(path.string(), content)) return;
    std::error_code tried;  // where there is none after this, the file says so
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), tried);
    OutputFile file(path.string());
    file.write(content);
    file.commit();
}

/// The file of the start in [start] of a written scene: the scene's own where that can be read there or be written
/// under its name; else, of a moment of a trajectory, one of its values.
std::string start_file(const std::filesystem::path& folder, const RunDescription& run, const std::string& values) {
    if (run.start.from || !run.origin) return values;
    std::string own = model_of(run).scene(run.scene).start.file;
    for (const SceneFile::Part& part : run.origin->parts) {
        if (own.empty() || part.name != own) continue;
        const bool is_moment = file_at_step(own).step || own.ends_with(".trajectory");
        if (!is_moment || reads_there(folder, part, ParticleFiles::Use::start)) return ParticleFiles::name_below(own);
    }
    return values;
}

void write_read_files(const std::filesystem::path& folder, const RunDescription& run, const std::string& start) {
    if (run.start.from) write_beside(folder, start, csv_text(*run.start.from));
    if (!run.origin) return;
    const std::string own_start = model_of(run).scene(run.scene).start.file;
    for (const SceneFile::Part& part : run.origin->parts) {
        if (part.name.empty()) continue;
        const bool starts = part.name == own_start;
        if (reads_there(folder, part, starts ? ParticleFiles::Use::start : ParticleFiles::Use::particles)) continue;
        if (starts && run.start.from) continue;  // its values take the place of these
        write_beside(folder, starts ? start : ParticleFiles::name_below(part.name), part.content);
    }
}

}  // namespace

void write_scene(const std::string& out, const RunDescription& run, const SceneView& view) {
    const std::filesystem::path path(out);
    const std::string start =
        out == standard_output ? "" : start_file(path.parent_path(), run, path.stem().string() + "-start.csv");
    const std::string text = scene_file_text(run, view, start);
    if (out != standard_output)
        write_read_files(path.parent_path(), run, start);
    else if (run.start.from)
        throw UsageError("a scene with --from needs --out FILE: the values are written beside it");
    OutputFile file(out);
    file.write(text);
    file.commit();
}

void write_scene(const std::string& out, const RunDescription& run) { write_scene(out, run, view_of(run)); }

}  // namespace steplab
