#include "io/trajectory_format.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>

namespace steplab {

namespace {

constexpr std::array<std::string_view, 3> format_names{"csv", "xyz", "trajectory"};

}  // namespace

TrajectoryFormat trajectory_format(std::string_view name) {
    const auto found = std::find(format_names.begin(), format_names.end(), name);
    if (found == format_names.end()) throw UsageError(unknown_word("format", name, format_names));
    return static_cast<TrajectoryFormat>(found - format_names.begin());
}

TrajectoryFormat trajectory_format_of(const std::string& file) {
    std::error_code ignored;  // a folder is refused as such when it is opened
    if (written_directly(file) || std::filesystem::is_directory(file, ignored)) return TrajectoryFormat::csv;
    std::string ending = std::filesystem::path(file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (!ending.empty()) ending.erase(0, 1);
    const auto found = std::find(format_names.begin(), format_names.end(), ending);
    if (found == format_names.end()) {
        throw UsageError(fmt::format("the extension of '{}' is not a known format: use .{}, or add --format {}", file,
                                     joined(format_names, " or ."), joined(format_names, " or --format ")));
    }
    return static_cast<TrajectoryFormat>(found - format_names.begin());
}

}  // namespace steplab
