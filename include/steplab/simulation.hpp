#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <steplab/run.hpp>
#include <steplab/scene.hpp>
#include <steplab/visibility.hpp>
#include <string>

namespace steplab::library {

/// A picture: rows from the top, 4 bytes per pixel (red, green, blue, alpha).
struct Picture {
    std::size_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// How a picture is drawn.
struct View {
    std::size_t width = 640, height = 360;  ///< pixels, 1 to 8192
    std::string camera = {};                ///< default, front, side, top or yaw,pitch,distance,x,y,z; empty: default
};

/// A run under way, a few steps at a time. To be used by one thread at a time.
///
///     Simulation simulation(Scene::model("chain"), {.method = "pefrl", .dt = 0.05});
///     simulation.advance(100);
///     std::vector<double> x(3 * simulation.particles());
///     simulation.positions(x);
class STEPLAB_PUBLIC Simulation {
public:
    /// Throws UsageError.
    explicit Simulation(const Scene& scene, const Settings& settings = {});
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Takes this many steps. If the run diverges it stands at its last valid step, and goes no further. Throws
    /// Interrupted; the run is lost then.
    void advance(std::uint64_t steps);

    std::uint64_t step() const;
    double time() const;  ///< [s]
    std::size_t particles() const;
    std::uint64_t evaluations() const;
    double energy() const;        ///< [J]
    double energy_error() const;  ///< [J], since the start
    /// Empty unless the run diverged: then why.
    std::string divergence() const;
    /// Of the present state, as `steplab run` prints it.
    std::string hash() const;

    /// Copies 3 n numbers, x y z of each particle, to `out`. Throws UsageError if it has another length.
    void positions(std::span<double> out) const;   ///< [m]
    void velocities(std::span<double> out) const;  ///< [m/s]
    void forces(std::span<double> out) const;      ///< [N]

    /// Draws the present state without a display, by a module that is loaded at the first picture. Throws GraphicsError
    /// if there is none, UsageError.
    Picture snapshot(const View& view = {}) const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab::library
