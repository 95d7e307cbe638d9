#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// With Shift, arrows move the edges of panel and plots, and Home gives both their usual size. True where one of these
/// keys was pressed: it then has no other meaning.
bool use_size_keys(const Context& context);

}  // namespace steplab::ui
