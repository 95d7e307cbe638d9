#include "sim/steppers/pieces.hpp"

#include <algorithm>

namespace steplab {

namespace {

void copy(const State<double>& from, std::size_t first, std::size_t count, State<double>& to, std::size_t place) {
    copy(from.displacement, first, count, to.displacement, place);
    copy(from.velocity, first, count, to.velocity, place);
}

}  // namespace

Pieces::Pieces(std::size_t particles, std::size_t length, std::size_t shared)
    : particles_(particles),
      length_(length),
      shared_(shared),
      capacity_(std::min(particles, length + shared)),
      count_(particles <= length + shared ? 1 : (particles - shared + length - 1) / length) {}

void Pieces::each(std::size_t parts, const std::function<void(const PortionSink&)>& emit, const PieceSink& sink) {
    parts_.resize(parts);
    for (Part& part : parts_) part.begun = false;
    emit([&](const Portion& portion) { add(portion, sink); });
    join(sink);
}

void Pieces::begin(Part& part, std::size_t first) const {
    const std::size_t piece = (first + length_ - 1) / length_;
    part.begun = true;
    part.head.first = first;
    part.body.first = piece < count_ ? piece * length_ : particles_;
    part.head_end = first == 0 ? 0 : std::min(part.body.first + shared_, particles_);
    part.head.count = part.body.count = 0;
}

void Pieces::add(const Portion& portion, const PieceSink& sink) {
    Part& part = parts_[portion.part];
    if (!part.begun) begin(part, portion.first);
    hold(part.head, portion, part.head_end);
    cut(part.body, portion, sink);
}

/// Takes what comes next of the portion, up to `end`.
void Pieces::hold(Stretch& stretch, const Portion& portion, std::size_t end) const {
    const std::size_t from = stretch.end(), to = std::min(end, portion.first + portion.count);
    if (from >= to) return;
    if (stretch.state.velocity.count() != capacity_)
        stretch.state = {Field<double>(capacity_), Field<double>(capacity_)};
    copy(portion.state, portion.place + from - portion.first, to - from, stretch.state, stretch.count);
    stretch.count += to - from;
}

void Pieces::cut(Stretch& stretch, const Portion& portion, const PieceSink& sink) const {
    while (stretch.end() < portion.first + portion.count) {
        hold(stretch, portion, stretch.first + capacity_);
        if (stretch.count == capacity_ || stretch.end() == particles_) finish(stretch, sink);
    }
}

void Pieces::finish(Stretch& stretch, const PieceSink& sink) const {
    const std::size_t own = stretch.end() == particles_ ? stretch.count : length_;
    sink({stretch.first / length_, stretch.first, own, stretch.count, stretch.state});
    stretch.count -= own;
    stretch.first += own;
    copy(stretch.state, own, stretch.count, stretch.state, 0);
}

/// Pieces that lie in several parts: the end of one, and the heads of those behind it.
void Pieces::join(const PieceSink& sink) {
    Stretch* open = nullptr;
    for (Part& part : parts_) {
        if (!part.begun) continue;
        if (open) cut(*open, {part.head.first, part.head.count, part.head.state}, sink);
        if (part.head.end() >= part.head_end) open = &part.body;
    }
}

}  // namespace steplab
