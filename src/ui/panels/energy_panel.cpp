#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {

void draw_energy_panel(const Context& context) {
    const Diagnostics& now = context.view.diagnostics;
    heading(context, "ENERGY");
    reading_row(context, "kinetic", with_unit(reading_text(now.kinetic), "J"));
    reading_row(context, "potential", with_unit(reading_text(now.potential), "J"));
    reading_row(context, "total", with_unit(reading_text(now.energy), "J"));
    reading_row(context, "momentum", vector(now.momentum), "sum over all particles, kg m/s");
    reading_row(context, "angular mom.", vector(now.angular_momentum), "about the origin, kg m²/s");
}

}  // namespace steplab::ui
