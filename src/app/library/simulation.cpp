#include "sim/run/simulation.hpp"

#include "app/library/implementation.hpp"
#include "app/offscreen/modules.hpp"
#include "core/appearance.hpp"
#include "core/error.hpp"
#include "session/run_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <dlfcn.h>
#include <filesystem>
#include <mutex>
#include <steplab/simulation.hpp>
#include <utility>

namespace steplab::library {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_side = 8192;

/// The folder of the modules that draw, beside this library, or beside the program that it is part of.
fs::path modules_here() {
    Dl_info here{};
    if (dladdr(reinterpret_cast<const void*>(&modules_here), &here) == 0 || !here.dli_fname) return module_folder();
    std::error_code none;
    const fs::path beside = fs::canonical(here.dli_fname, none).parent_path() / "steplab";
    return fs::is_directory(beside, none) ? beside : module_folder();
}

void copy_vectors(std::span<const Vec3> from, std::span<double> to) {
    const auto all = numbers(from);
    if (all.size() != to.size())
        throw steplab::UsageError(
            fmt::format("{} particles have {} numbers, but there is room for {}", from.size(), all.size(), to.size()));
    std::copy(all.begin(), all.end(), to.begin());
}

}  // namespace

struct Simulation::Body {
    steplab::Simulation run;
};

Simulation::Simulation(const Scene& scene, const Settings& settings)
    : body_(translated([&] {
          return std::make_unique<Body>(
              Body{steplab::Simulation(described(scene, settings), {.threads = settings.threads})});
      })) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps) {
    translated([&] { body_->run.advance(steps); });
}

std::uint64_t Simulation::step() const { return body_->run.step(); }
double Simulation::time() const { return body_->run.time(); }
std::size_t Simulation::particles() const { return body_->run.particles(); }
std::uint64_t Simulation::evaluations() const { return body_->run.evaluations(); }
double Simulation::energy() const { return body_->run.energy(); }
double Simulation::energy_error() const { return body_->run.energy_error(); }
std::string Simulation::divergence() const {
    const auto& divergence = body_->run.divergence();
    return divergence ? divergence->message : std::string();
}
std::string Simulation::hash() const { return body_->run.hash(); }

void Simulation::positions(std::span<double> out) const {
    translated([&] { copy_vectors(body_->run.frame().positions, out); });
}
void Simulation::velocities(std::span<double> out) const {
    translated([&] { copy_vectors(body_->run.frame().velocities, out); });
}
void Simulation::forces(std::span<double> out) const {
    translated([&] {
        std::vector<Vec3> forces;
        body_->run.forces(forces);
        copy_vectors(forces, out);
    });
}

Picture Simulation::snapshot(const View& view) const {
    return translated([&] {
        const auto allowed = [](std::size_t side) { return side >= 1 && side <= longest_side; };
        if (!allowed(view.width) || !allowed(view.height))
            throw steplab::UsageError(fmt::format("a picture has 1 to {} pixels along each side (got {} x {})",
                                                  longest_side, view.width, view.height));
        if (!view.camera.empty()) parse_view(view.camera, "camera");
        PictureRequest request;
        request.view = view_of(body_->run);
        if (!view.camera.empty()) request.camera = view.camera;
        request.size = {static_cast<int>(view.width), static_cast<int>(view.height)};
        static std::mutex drawing;  // contexts of one driver may not draw at the same time: draws_on_several_threads()
        const std::lock_guard lock(drawing);
        Offscreen offscreen("auto", modules_here());
        return Picture{view.width, view.height, offscreen.draw(request).rgba};
    });
}

}  // namespace steplab::library
