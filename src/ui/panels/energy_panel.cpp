#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {
namespace {

/// The label and, below it, the value: in one line they overlap if the components have many digits.
void vector_row(const Context& context, std::string_view label, Vec3 value, std::string_view what) {
    reading_row(context, label, "", what);
    reading_row(context, "", vector(value), what);
}

}  // namespace

void draw_energy_panel(const Context& context) {
    if (context.session.playback && !context.session.playback->measured) return;
    const Diagnostics& now = context.view.diagnostics;
    heading(context, "ENERGY AND MOMENTUM");
    reading_row(context, "kinetic energy", with_unit(reading_text(now.kinetic), "J"));
    reading_row(context, "potential energy", with_unit(reading_text(now.potential), "J"));
    reading_row(context, "total energy", with_unit(reading_text(now.energy), "J"));
    vector_row(context, "momentum [kg m/s]", now.momentum, "sum over all particles");
    vector_row(context, "angular momentum [kg m²/s]", now.angular_momentum, "about the origin, sum over all particles");
}

}  // namespace steplab::ui
