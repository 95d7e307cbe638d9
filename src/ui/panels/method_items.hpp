#pragma once

#include "ui/widgets/widgets.hpp"

#include <vector>

namespace steplab::ui {

/// All methods as items of a menu, group after group.
std::vector<ComboItem> method_items();

}  // namespace steplab::ui
