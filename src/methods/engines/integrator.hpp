#pragma once

#include "core/collision.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/own_stop.hpp"
#include "core/vector.hpp"
#include "methods/engines/counted_drag.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace steplab {

/// How an integrator meets the forces of a scene, which decides how its stepper is compiled.
enum class Forcing {
    erased,       ///< long steps: one stepper, which calls the layout of forces through a virtual call per evaluation
    kick_drift,   ///< kicks and drifts: one stepper on every layout serves all such methods (kick_drift.hpp)
    runge_kutta,  ///< stages that each start from one slope: a stepper on every layout that sweeps (runge_kutta.hpp)
    plain         ///< absolute positions and the plain force loop: the methods as printed in 2008
};

/// What an integrator has beyond what every one must have. Each names the members that come with it; IntegratorOf holds
/// only where exactly the capabilities whose members are there are declared.
struct IntegratorCapabilities {
    Forcing forcing = Forcing::erased;
    bool lanes = false;       ///< runs of an ensemble, one in each SIMD lane
    bool advances = false;    ///< advance(system, n): n steps at once, faster than one by one
    bool emits = false;       ///< emit(system, sink): sink(r, x, v) for every register r of particles
    bool reach = false;       ///< reach(): springs that a step reaches; without it a step needs the whole scene
    bool progress = false;    ///< Progress, progress(), progress(p): plain data of the internal state that is no field
    bool stops = false;       ///< stopped(): it says where no step of its own does; a number of its state is none then
    bool collisions = false;  ///< collisions(): it finds collisions where a force jumps (collisions.hpp)
    bool drag_work = false;   ///< counted_drag(), drag_work(system): the work of drag, counted beside the steps
};

namespace detail {

template <class I, class System>
concept HasAdvance = requires(I& integrator, System& system) {
    integrator.advance(system, std::uint64_t{1});
};

struct AnyRegisterSink {
    template <class Vec>
    void operator()(std::size_t, const Vec&, const Vec&) const {}
};
template <class I, class System>
concept HasEmit = requires(const I& integrator, const System& system) {
    integrator.emit(system, AnyRegisterSink());
};

template <class I>
concept HasReach = requires(const I& integrator) {
    { integrator.reach() } -> std::convertible_to<std::size_t>;
};

template <class I>
concept HasProgress = requires(I& integrator, const I& same, const typename I::Progress& progress) {
    { same.progress() } -> std::same_as<typename I::Progress>;
    integrator.progress(progress);
};

template <class I>
concept HasStops = requires(const I& integrator) {
    { integrator.stopped() } -> std::same_as<std::optional<OwnStop>>;
};

template <class I>
concept HasCollisions = requires(const I& integrator) {
    { integrator.collisions() } -> std::convertible_to<CollisionRecord>;
};

template <class I, class System>
concept HasDragWork = requires(I& integrator, const I& same, const System& system) {
    { integrator.counted_drag() } -> std::same_as<CountedDrag&>;
    { same.counted_drag() } -> std::same_as<const CountedDrag&>;
    { same.drag_work(system) } -> std::same_as<double>;
};

struct AnyPart {
    template <class T>
    void operator()(const Field<T>&) const {}
};

}  // namespace detail

/// An integrator: the class template Integrator<T> of a method, of systems x'' = a(x) - gamma v (system.hpp).
///   Integrator(const ParameterValues&)
///   start(System&, State<T>)                        begins a segment at a synchronised state
///   step(System&)                                   one step of dt; an adaptive one takes steps of its own until dt is
///                                                   reached
///   synchronised(const System&, State<T>&) const    x and v of one time, without changing anything
///   each_part(self, f)                              f(field) for every field of its internal state
/// and its capabilities, exactly. Anything else it holds is scratch: the internal state alone decides how a run goes
/// on.
template <class I, class T, class System>
concept IntegratorOf = std::constructible_from<I, const ParameterValues&> &&
    requires(I& integrator, const I& same, System& system, const System& same_system, State<T> state, State<T>& out) {
    { I::capabilities } -> std::convertible_to<IntegratorCapabilities>;
    integrator.start(system, std::move(state));
    integrator.step(system);
    same.synchronised(same_system, out);
    I::each_part(integrator, detail::AnyPart());
} && I::capabilities.advances == detail::HasAdvance<I, System>&& I::capabilities.emits ==
    detail::HasEmit<I, System>&& I::capabilities.reach == detail::HasReach<I>&& I::capabilities.progress ==
    detail::HasProgress<I>&& I::capabilities.stops == detail::HasStops<I>&& I::capabilities.collisions ==
    detail::HasCollisions<I>&& I::capabilities.drag_work == detail::HasDragWork<I, System>;

}  // namespace steplab
