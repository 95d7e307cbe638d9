#pragma once

#include "core/field.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace steplab {

/// Neighbours of a scene: the first `own` are the piece's alone, those behind them begin the next one too.
struct Piece {
    std::size_t number;  ///< of this piece, in the order of particles
    std::size_t first;   ///< particle
    std::size_t own, held;
    const State<double>& state;  ///< of those held, or of more
};
/// Called by several threads at once if particles are emitted in parallel, for each piece by one of them.
using PieceSink = std::function<void(const Piece&)>;

/// Cuts a scene's particles into pieces that are the same however they are shown: in which portions, and in how many
/// parts in parallel. Sums over pieces therefore have the same bits.
class Pieces {
public:
    /// Each has `length` particles of its own, at least 1, and `shared` that the next begins with, at most as many. The
    /// last one has what is left.
    Pieces(std::size_t particles, std::size_t length, std::size_t shared);

    /// How many there are.
    std::size_t count() const { return count_; }
    /// All pieces of what `emit` emits as Stepper::emit_parallel() does, in `parts`.
    void each(std::size_t parts, const std::function<void(const PortionSink&)>& emit, const PieceSink& sink);

private:
    /// Particles next to each other, held until they are a piece.
    struct Stretch {
        std::size_t first = 0, count = 0;
        State<double> state;

        std::size_t end() const { return first + count; }
    };
    /// What is not yet in a piece of a part: its first particles, up to where the first piece of its own begins and
    /// those this one shares, belong to a piece that begins in the part before.
    struct Part {
        bool begun = false;
        std::size_t head_end = 0;
        Stretch head, body;
    };

    void begin(Part& part, std::size_t first) const;
    void add(const Portion& portion, const PieceSink& sink);
    void hold(Stretch& stretch, const Portion& portion, std::size_t end) const;
    void cut(Stretch& stretch, const Portion& portion, const PieceSink& sink) const;
    void finish(Stretch& stretch, const PieceSink& sink) const;
    void join(const PieceSink& sink);

    std::size_t particles_, length_, shared_;
    std::size_t capacity_;  ///< of a piece with what it shares
    std::size_t count_;
    std::vector<Part> parts_;
};

}  // namespace steplab
