#pragma once

#include "ui/context.hpp"

#include <functional>
#include <string_view>

namespace steplab::ui {

/// A row for each parameter: slider, tick or switch, as its kind asks. `owner` begins the widgets' names: "scene.k".
/// `set` gets the values with one changed.
void parameter_rows(const Context& context, std::string_view owner, const ParameterValues& values,
                    const std::function<void(const ParameterValues&)>& set);

/// What a tooltip tells of a parameter: what it is, its range, default, and what changing it does.
std::string parameter_help(const ParameterInfo& info);

}  // namespace steplab::ui
