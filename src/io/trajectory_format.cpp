#include "io/trajectory_format.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/compression.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <vector>

namespace steplab {

namespace {

constexpr std::array<std::string_view, 3> format_names{"csv", "xyz", "trajectory"};

/// A further file name extension of XYZ.
constexpr std::string_view extended_xyz = "extxyz";

std::vector<std::string_view> with(std::span<const std::string_view> others) {
    std::vector<std::string_view> all(format_names.begin(), format_names.end());
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

}  // namespace

TrajectoryFormat trajectory_format(std::string_view name, std::span<const std::string_view> others) {
    const auto found = std::find(format_names.begin(), format_names.end(), name);
    if (found == format_names.end()) throw UsageError(unknown_word("format", name, with(others)));
    return static_cast<TrajectoryFormat>(found - format_names.begin());
}

TrajectoryFormat trajectory_format_of(const std::string& file, std::span<const std::string_view> others) {
    std::error_code ignored;  // a folder is refused as such when it is opened
    if (written_directly(file) || std::filesystem::is_directory(file, ignored)) return TrajectoryFormat::csv;
    const std::string ending = extension_of(without_compression(file));
    if (ending == extended_xyz) return TrajectoryFormat::xyz;
    const auto found = std::find(format_names.begin(), format_names.end(), ending);
    if (found == format_names.end()) {
        throw UsageError(
            fmt::format("the extension of '{}' is not a known format: use .csv, .xyz or .{}, as they are "
                        "or with .gz or .zst behind, or .trajectory{}; or add --format {}",
                        shown(file), extended_xyz, others.empty() ? "" : ", ." + joined(others, ", ."),
                        joined(with(others), " or --format ")));
    }
    return static_cast<TrajectoryFormat>(found - format_names.begin());
}

void check_compression(TrajectoryFormat format, const std::string& file) {
    if (format == TrajectoryFormat::trajectory && compression_of(file) != Compression::none)
        throw UsageError(fmt::format(
            "'{}': a trajectory file is compressed as it is; .gz and .zst follow .csv and .xyz", shown(file)));
}

}  // namespace steplab
