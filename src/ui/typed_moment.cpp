#include "ui/typed_moment.hpp"

#include "core/entry.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace steplab::ui {
namespace {

constexpr ParameterInfo time_info{.name = "t", .unit = "s", .minimum = 0, .what = "time"};
constexpr ParameterInfo step_info{
    .name = "step", .kind = ParameterInfo::Kind::integer, .unit = "", .minimum = 0, .maximum = 9e15, .what = "step"};

}  // namespace

Event typed_moment(std::string_view text) {
    constexpr std::string_view word = "step ";
    if (text.starts_with(word))
        return event::Seek{static_cast<std::uint64_t>(parse_value(step_info, text.substr(word.size())))};
    try {
        return event::SeekTime{parse_value(time_info, text)};
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}, or a step, such as \"step 120\"", error.what()));
    }
}

}  // namespace steplab::ui
