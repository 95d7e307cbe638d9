#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <steplab/visibility.hpp>
#include <string>
#include <utility>
#include <vector>

namespace steplab::library {

struct SceneState;

/// The value of a parameter: a number, or a text as the command line has it ("corner").
class STEPLAB_PUBLIC Value {
public:
    explicit(false) Value(double number);
    explicit(false) Value(int number) : Value(static_cast<double>(number)) {}
    explicit(false) Value(std::string text) : text_(std::move(text)) {}
    explicit(false) Value(const char* text) : text_(text) {}
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// Values by name: of the parameters of a model, a scene file or a method.
using Parameters = std::map<std::string, Value>;

/// What particles are given as. Each vector has three components, x y z after each other.
struct Particles {
    std::vector<double> positions;        ///< 3 n [m]
    std::vector<double> velocities = {};  ///< 3 n [m/s]; empty: at rest
    std::vector<double> masses = {};      ///< n [kg], > 0; empty: 1 each
};

/// Forces between all pairs of particles, by a potential energy V(r): the name of a built-in one, or an expression in
/// the distance r [m], the masses m1 and m2, the charges q1 and q2 and the names in `values`; the force is its exact
/// derivative (docs/scene-files.md). With a cut-off [m] both go to 0 there.
struct PairForce {
    std::string potential;
    Parameters values = {};
    std::optional<double> cutoff = {};
};

/// Particles and what acts on them, as a value: copies are cheap, and nothing changes a scene that is there.
///
///     const auto chain = Scene::model("chain", {{"n", 20}});
class STEPLAB_PUBLIC Scene {
public:
    /// A model of the catalogue with these parameters, the others at their defaults. Throws UsageError.
    static Scene model(const std::string& id, const Parameters& parameters = {});
    /// A scene file (docs/scene-files.md), or by a name without slash and `.toml` one that comes with steplab. Throws
    /// FileError, UsageError.
    static Scene from_file(const std::string& name, const Parameters& parameters = {});
    /// The text of a scene file that reads no other file. Throws FileError.
    static Scene from_text(const std::string& text, const Parameters& parameters = {});
    /// What saved() gave. Throws FileError for any other text.
    static Scene restored(const std::string& saved);
    /// These particles, on which nothing acts. Throws UsageError if the lengths do not fit together or a number is not
    /// finite.
    static Scene of(const Particles& particles);

    Scene(const Scene&) = default;
    Scene(Scene&&) = default;
    Scene& operator=(const Scene&) = default;
    Scene& operator=(Scene&&) = default;
    ~Scene();

    /// The same with other parameters. Throws UsageError.
    Scene with_parameters(const Parameters& parameters) const;
    /// The same with a force between all pairs besides. Throws UsageError for a potential that cannot be read.
    Scene with_pair_force(const PairForce& force) const;
    /// The same particles and forces, but from these positions [m] and velocities [m/s], 3 n numbers each. Throws
    /// UsageError.
    Scene starting_at(std::span<const double> positions, std::span<const double> velocities) const;

    /// The id of the model, or the name of the scene file.
    std::string name() const;
    std::size_t particles() const;
    Parameters parameters() const;
    /// At the start: 3 n numbers each, and n masses.
    Particles start() const;
    /// As the text of a scene file, which gives the same bits. Throws UsageError, with the reason, for a scene that one
    /// text cannot hold: one that was given another start, or needs the files that it reads.
    std::string text() const;
    /// All of it as a text for restored(), the files that it was read from too: these may be gone then.
    std::string saved() const;

    /// Of the implementation.
    explicit Scene(std::shared_ptr<const SceneState> state);
    const SceneState& state() const { return *state_; }

private:
    std::shared_ptr<const SceneState> state_;
};

/// The names of what there is: models, methods (those added by add_method() last), and scenes that come with steplab.
STEPLAB_PUBLIC std::vector<std::string> models();
STEPLAB_PUBLIC std::vector<std::string> methods();
STEPLAB_PUBLIC std::vector<std::string> scenes();

}  // namespace steplab::library
