#pragma once

#include "ui/context.hpp"

#include <functional>
#include <string_view>

namespace steplab::ui {

/// A row for each parameter: a slider, a check box or a switch, depending on its kind. The names of the widgets begin
/// with `owner`: "scene.k". `set` is called with the values of which one has changed.
void parameter_rows(const Context& context, std::string_view owner, const ParameterValues& values,
                    const std::function<void(const ParameterValues&)>& set);

/// The tooltip of a parameter: its meaning, range and default, and the effect of a change.
std::string parameter_help(const ParameterInfo& info);

}  // namespace steplab::ui
