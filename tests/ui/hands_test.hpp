#pragma once

#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace steplab::ui {

struct DisplayPoint {
    float x, y;
};

/// Where a particle is on the display.
inline DisplayPoint place_of(const Desk& desk, std::size_t particle) {
    const PixelRect rect = desk.interface.scene();
    const auto pixel = render::Projection(desk.camera, {rect.width, rect.height}).pixel(desk.view.frame.seen(particle));
    return {static_cast<float>(rect.x + pixel.value().x), static_cast<float>(rect.y + pixel.value().y)};
}

/// A chain of which particle 5 is the one that views tell about.
class WithHands : public testing::Test {
protected:
    WithHands() {
        desk.show(view_of(simulation, 5));
        desk.frame();
        desk.recorder = {};
    }

    void hold_keys(const ModifiersChanged& keys) { desk.interface.input().push(keys); }
    void click(std::size_t particle) {
        const DisplayPoint place = place_of(desk, particle);
        desk.move_to(place.x, place.y);
        desk.press();
        desk.release();
    }
    /// A box around these particles and all between them.
    void drag_box(std::size_t first, std::size_t last) {
        const DisplayPoint from = place_of(desk, first), to = place_of(desk, last);
        desk.move_to(from.x - 12, from.y - 30);
        desk.press();
        desk.move_to(to.x + 12, to.y + 30);
        desk.release();
    }
    std::vector<std::size_t> others() const { return {desk.style.selected_too.begin(), desk.style.selected_too.end()}; }
    template <class Kind>
    Kind last_act() const {
        return std::get<Kind>(std::get<event::Do>(desk.recorder.events.back()).act);
    }
    /// The run has gone on by a step, playing.
    void play_a_step() {
        simulation.advance(1);
        RunView view = view_of(simulation, 5);
        view.playing = true;
        desk.show(view);
    }

    Simulation simulation{describe("chain")};
    Desk desk{describe("chain")};
};

}  // namespace steplab::ui
