#pragma once

#include "session/event.hpp"

#include <string_view>

namespace steplab::ui {

/// Where a person who types a moment wants to go: "12.5" or "step 120". Throws UsageError.
Event typed_moment(std::string_view text);

}  // namespace steplab::ui
