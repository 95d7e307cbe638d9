#include "io/particle_files.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/starting_values_file.hpp"
#include "io/text_trajectory.hpp"
#include "io/trajectory_reader.hpp"
#include "sim/run/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

namespace fs = std::filesystem;

/// A file that lies, links followed, in this folder or below it.
InputFile file_inside(const fs::path& folder, const std::string& name) {
    std::error_code error;
    const fs::path home = fs::canonical(folder.empty() ? "." : folder, error);
    const fs::path file = fs::canonical(home / name, error);
    if (error) throw FileError(fmt::format("cannot read '{}': {}", shown(name), error.message()));
    const auto [in_home, in_file] = std::mismatch(home.begin(), home.end(), file.begin(), file.end());
    if (in_home != home.end() || in_file == file.end())
        throw FileError(fmt::format("'{}' must lie in the folder of the scene file", shown(name)));
    return InputFile(file.string());
}

/// A text that is not copied.
TextInput input_of(const std::string& name, const std::string& text) {
    return {name, std::shared_ptr<const std::string>(std::shared_ptr<const std::string>(), &text)};
}

/// Rows have a line each, so that the memory is known before any is taken.
void check_memory(const std::string& name, const std::string& text) {
    constexpr double bytes_of_row = sizeof(ListedParticles::Particle) + 2 * sizeof(Vec3) + sizeof(double) + 1;
    const double needed = static_cast<double>(std::count(text.begin(), text.end(), '\n')) * bytes_of_row;
    if (needed > available_memory())
        throw FileError(
            fmt::format("cannot read '{}': its particles need {:.0f} bytes of memory", shown(name), needed));
}

FrameBlock last_frame(const std::string& name, const std::string& text) {
    check_memory(name, text);
    const auto file = TextTrajectory::open(input_of(name, text), TextTrajectory::From::any_program);
    file->require({Column::x, Column::y, Column::z});
    FrameBlock frame;
    for (FrameBlock next; file->next(next);) frame = std::move(next);
    if (frame.rows == 0) throw FileError(fmt::format("cannot read '{}': it holds no particles", shown(name)));
    return frame;
}

ListedParticles listed(const std::string& name, const std::string& text) {
    const FrameBlock frame = last_frame(name, text);
    ListedParticles list{
        .file = name, .masses = frame.masses.size() == frame.rows, .roles = frame.roles.size() == frame.rows};
    std::vector<ListedParticles::Particle> particles(frame.rows);
    for (std::size_t i = 0; i < frame.rows; ++i) {
        particles[i].position = frame.positions[i];
        if (!frame.velocities.empty()) particles[i].velocity = frame.velocities[i];
        if (list.roles) particles[i].role = frame.roles[i];
        if (list.masses) particles[i].mass = frame.masses[i];
        if (!(particles[i].mass > 0))
            throw FileError(fmt::format("cannot read '{}': the mass of particle {} must be > 0", shown(name), i));
    }
    list.particles = std::make_shared<const std::vector<ListedParticles::Particle>>(std::move(particles));
    return list;
}

}  // namespace

std::string ParticleFiles::text_in(const fs::path& folder, const std::string& name, Use use) {
    const FileAtStep at = use == Use::start ? file_at_step(name) : FileAtStep{name};
    InputFile file = file_inside(folder, at.file);
    const bool moment = at.step || (use == Use::start && TrajectoryReader::reads(file));
    if (moment) return csv_text(starting_values(std::move(file), at.step));
    const double most = available_memory() / 4;
    return TextInput(std::move(file)).rest(static_cast<std::size_t>(most));
}

std::string ParticleFiles::name_below(const std::string& name) {
    const fs::path path = fs::path(name).lexically_normal();
    return path.is_absolute() || path.begin()->string() == ".." ? path.filename().string() : name;
}

ParticleFiles ParticleFiles::in_folder(const fs::path& folder) {
    return ParticleFiles([folder](const std::string& name, Use use) { return text_in(folder, name, use); });
}

ParticleFiles ParticleFiles::carried(std::vector<SceneFile::Part> parts) {
    return ParticleFiles([parts = std::move(parts)](const std::string& name, Use) {
        const auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; });
        if (part == parts.end())
            throw FileError(fmt::format("cannot read '{}': the run does not carry it", shown(name)));
        return part->content;
    });
}

const std::string& ParticleFiles::text(const std::string& name, Use use) {
    const auto known = std::find_if(parts_.begin(), parts_.end(), [&](const auto& part) { return part.name == name; });
    if (known != parts_.end()) return known->content;
    return parts_.emplace_back(SceneFile::Part{name, source_(name, use)}).content;
}

const ListedParticles& ParticleFiles::particles(const std::string& name) {
    const auto known = particles_.find(name);
    if (known != particles_.end()) return known->second;
    return particles_.emplace(name, listed(name, text(name, Use::particles))).first->second;
}

std::shared_ptr<const StartingValues> ParticleFiles::start(const std::string& name) {
    std::shared_ptr<const StartingValues>& known = starts_[name];
    if (known) return known;
    StartingValues values = starting_values(input_of(name, text(name, Use::start)), {});
    values.given = name;
    return known = std::make_shared<const StartingValues>(std::move(values));
}

}  // namespace steplab
