#include "io/frame_finder.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/number_read.hpp"

#include <fmt/format.h>

namespace steplab {

void FrameFinder::Line::fail(const std::string& reason) const {
    throw FileError(fmt::format("line {}: {}", number + 1, reason));
}

std::unique_ptr<FrameFinder> frame_finder(TextInput& text) {
    switch (format_of(text, TextTrajectory::From::any_program)) {
        case TextFormat::csv:
            return csv_finder();
        case TextFormat::xyz:
            return xyz_finder();
        default:
            return dump_finder();
    }
}

template <class Number>
Number number_of(const FrameFinder::Line& line, std::string_view word) {
    const auto value = number_in<Number>(word);
    if (!value) line.fail(no_number_text(word));
    return *value;
}
template double number_of<double>(const FrameFinder::Line& line, std::string_view word);
template std::uint64_t number_of<std::uint64_t>(const FrameFinder::Line& line, std::string_view word);

}  // namespace steplab
