#pragma once

#include "session/event.hpp"

#include <string_view>

namespace steplab {

/// What an event is called in session files and messages: "pull", "seek-time". Of events that are recorded.
std::string_view word_of(const Event& event);

}  // namespace steplab
