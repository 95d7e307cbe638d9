#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <steplab/visibility.hpp>
#include <string>

namespace steplab {
class OwnMotion;
}

namespace steplab::library {

/// What a step of a method works on. All spans have the same length, padding included: treat them element by element.
class STEPLAB_PUBLIC Motion {
public:
    explicit Motion(OwnMotion& motion) : motion_(motion) {}

    double dt() const;  ///< [s]
    /// Displacements from the reference positions [m] and velocities [m/s], which the step is to change.
    std::span<double> positions();
    std::span<double> velocities();
    /// The accelerations [m/s^2] that forces and drag give at such positions and velocities: one evaluation. The result
    /// is valid until the next one.
    std::span<const double> accelerations(std::span<const double> positions, std::span<const double> velocities);
    /// Memory for intermediate values, by its number; another step finds anything in it.
    std::span<double> scratch(std::size_t number);

private:
    OwnMotion& motion_;
};

/// How a method describes itself.
struct MethodDescription {
    std::string id;           ///< a word in lower case: "my-method"
    std::string name = {};    ///< for people
    std::string what = {};    ///< one sentence
    int order = 1;            ///< 1 or more
    int order_with_drag = 1;  ///< on scenes with drag
    int evaluations = 1;      ///< of the forces in a step
    bool symplectic = false, reversible = false;
};

/// A method of one's own, with one step of dt as its only state: positions and velocities of one time. Its object is
/// used by several threads at once.
class STEPLAB_PUBLIC Method {
public:
    virtual ~Method();
    virtual MethodDescription description() const = 0;
    virtual void step(Motion& motion) const = 0;
};

/// Makes a method known by its id to run(), Simulation and the lab, until the program ends. Its runs are in double, on
/// scenes without dashpots. Its stability limit is found here, from its steps. Throws UsageError.
STEPLAB_PUBLIC void add_method(std::shared_ptr<const Method> method);

}  // namespace steplab::library
