#include "render/lines.hpp"

namespace steplab::render {

Lines::Lines() : program_("line") {}

void Lines::draw(std::span<const Rod> lines, const ViewUniforms& view, double width) {
    if (lines.empty()) return;
    list_.upload(lines);
    view.apply(program_);
    program_.set("u_radius", 0.0F);
    program_.set("u_least_width", static_cast<float>(width));
    program_.set("u_breadth", 1.0F);
    program_.set("u_faded", -1.0F);
    program_.set("u_fading", 0.0F);
    program_.set("u_lit", 0.0F);
    list_.draw();
}

}  // namespace steplab::render
