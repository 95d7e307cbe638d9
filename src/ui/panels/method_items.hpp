#pragma once

#include "session/run_view.hpp"
#include "ui/widgets/widgets.hpp"

#include <vector>

namespace steplab::ui {

/// All methods as items of a menu, group after group; those that cannot run the scene of a view say why.
std::vector<ComboItem> method_items(const RunView& view);

}  // namespace steplab::ui
