#include "app/library/implementation.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/scene_file.hpp"
#include "io/scene_toml.hpp"
#include "io/scene_writer.hpp"
#include "io/trajectory_description.hpp"
#include "sim/catalogue.hpp"
#include "sim/own_methods.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <new>
#include <utility>

namespace steplab::library {

namespace {

/// The name of a scene that is given as text, in messages.
constexpr const char* text_name = "scene";
/// The file of particles that a scene of arrays reads.
constexpr const char* particles_file = "particles.xyz";

Scene scene_of(RunDescription run) { return Scene(std::make_shared<const SceneState>(SceneState{std::move(run)})); }

Scene scene_with(RunDescription run, const Parameters& parameters) {
    for (const auto& [name, value] : parameters) {
        if (!run.scene.contains(name) && run.method_parameters.contains(name))
            throw steplab::UsageError(
                fmt::format("'{}' is a parameter of the method {}: give it where a run is made", name, run.method));
        set_parameter(run, name, value.text());
    }
    check_values(run);
    return scene_of(std::move(run));
}

Scene scene_of_text(const std::string& text, std::vector<SceneFile::Part> files, const Parameters& parameters) {
    files.insert(files.begin(), {.name = "", .content = text});
    return scene_with(describe(scene_from(std::move(files), text_name)), parameters);
}

void check_masses(const std::vector<double>& masses, std::size_t particles) {
    if (!masses.empty() && masses.size() != particles)
        throw steplab::UsageError(fmt::format("masses: {} numbers for {} particles", masses.size(), particles));
    for (const double mass : masses) {
        if (!(mass > 0) || std::isinf(mass))
            throw steplab::UsageError(fmt::format("masses must be finite and > 0 (got {})", exact_text(mass)));
    }
}

/// Extended XYZ, exactly.
std::string xyz_of(const Particles& particles, std::span<const Vec3> positions, std::span<const Vec3> velocities) {
    std::string text = fmt::format("{}\nProperties=species:S:1:pos:R:3:velo:R:3:masses:R:1\n", positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3 x = positions[i], v = velocities.empty() ? Vec3() : velocities[i];
        text += "X";
        for (const double number : {x.x, x.y, x.z, v.x, v.y, v.z}) text += ' ' + number_text(number);
        text += ' ' + number_text(particles.masses.empty() ? 1.0 : particles.masses[i]) + '\n';
    }
    return text;
}

/// The text of the scene and the files that it reads.
std::vector<SceneFile::Part> files_of(const RunDescription& run) {
    if (!run.origin) return {};
    return {run.origin->parts.begin() + 1, run.origin->parts.end()};
}

std::string block_of(const PairForce& force) {
    std::string text = fmt::format("\n[[pairs]]\npotential = {}\n", toml_string(force.potential));
    for (const auto& [name, value] : force.values) {
        const bool number = parse_number(value.text()).has_value();
        text += fmt::format("{} = {}\n", toml_string(name), number ? value.text() : toml_string(value.text()));
    }
    if (force.cutoff) text += fmt::format("cutoff = {}\n", number_text(*force.cutoff));
    return text;
}

template <class Entries>
std::vector<std::string> ids_of(const Entries& entries) {
    std::vector<std::string> ids;
    for (const auto& entry : entries) ids.emplace_back(entry.info.id);
    return ids;
}

}  // namespace

Value::Value(double number) : text_(number_text(number)) {}

Scene::Scene(std::shared_ptr<const SceneState> state) : state_(std::move(state)) {}
Scene::~Scene() = default;

Scene Scene::model(const std::string& id, const Parameters& parameters) {
    return translated([&] { return scene_with(describe(id), parameters); });
}

Scene Scene::from_file(const std::string& name, const Parameters& parameters) {
    return translated([&] { return scene_with(describe(find_scene(name)), parameters); });
}

Scene Scene::from_text(const std::string& text, const Parameters& parameters) {
    return translated([&] { return scene_of_text(text, {}, parameters); });
}

Scene Scene::of(const Particles& particles) {
    return translated([&] {
        const std::size_t count = particles.positions.size() / 3;
        const auto positions = vectors(particles.positions, count, "positions");
        const auto velocities =
            particles.velocities.empty() ? std::vector<Vec3>() : vectors(particles.velocities, count, "velocities");
        check_masses(particles.masses, count);
        if (count == 0) throw steplab::UsageError("a scene has at least one particle");
        const std::string text =
            fmt::format("steplab = 1\ntitle = \"particles\"\n\n[[particles]]\ngroup = \"particles\"\nfile = \"{}\"\n",
                        particles_file);
        return scene_of_text(text, {{particles_file, xyz_of(particles, positions, velocities)}}, {});
    });
}

Scene Scene::with_parameters(const Parameters& parameters) const {
    return translated([&] { return scene_with(state_->run, parameters); });
}

Scene Scene::with_pair_force(const PairForce& force) const {
    return translated([&] {
        RunDescription before = state_->run;
        before.start = {};
        try {
            const Scene with = scene_of_text(scene_file_text(before) + block_of(force), files_of(before), {});
            RunDescription run = run_of(with);
            run.start = state_->run.start;
            return scene_of(std::move(run));
        } catch (const steplab::FileError& error) {
            throw steplab::UsageError(fmt::format("the pair force cannot be read: {}", error.what()));
        }
    });
}

Scene Scene::starting_at(std::span<const double> positions, std::span<const double> velocities) const {
    return translated([&] {
        RunDescription run = state_->run;
        const std::size_t count = particles();
        const StartingValues values{.given = "arrays",
                                    .positions = vectors(positions, count, "positions"),
                                    .velocities = vectors(velocities, count, "velocities")};
        run.start = {.from = std::make_shared<const StartingValues>(values)};
        check(run);
        return scene_of(std::move(run));
    });
}

std::string Scene::name() const { return state_->run.model; }

std::size_t Scene::particles() const {
    return translated([&] { return static_cast<std::size_t>(model_of(state_->run).particles(state_->run.scene)); });
}

Parameters Scene::parameters() const { return parameters_of(state_->run.scene); }

Particles Scene::start() const {
    return translated([&] {
        const Frame frame = steplab::Simulation(state_->run, {.threads = 1}).frame();
        const auto copy = [](std::span<const double> from) { return std::vector<double>(from.begin(), from.end()); };
        std::vector<double> masses = frame.shape->masses;
        if (masses.empty()) masses.assign(frame.positions.size(), frame.mass);
        return Particles{copy(numbers(frame.positions)), copy(numbers(frame.velocities)), std::move(masses)};
    });
}

std::string Scene::text() const {
    return translated([&] { return whole_scene_text(state_->run); });
}

std::string Scene::saved() const {
    return translated([&] { return trajectory::run_text(state_->run); });
}

Scene Scene::restored(const std::string& saved) {
    return translated([&] {
        try {
            RunDescription run = trajectory::parse_run(saved);
            check_values(run);
            return scene_of(std::move(run));
        } catch (const steplab::Error& error) {
            throw steplab::FileError(fmt::format("the saved scene cannot be restored: {}", error.what()));
        } catch (const steplab::Interrupted&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception&) {
            throw steplab::FileError("this is no scene that was saved by saved()");
        }
    });
}

std::vector<std::string> models() { return ids_of(steplab::models()); }

std::vector<std::string> methods() {
    std::vector<std::string> ids = ids_of(steplab::methods());
    for (const std::string_view id : own_method_ids()) ids.emplace_back(id);
    return ids;
}

std::vector<std::string> scenes() { return shipped_scenes(); }

}  // namespace steplab::library
