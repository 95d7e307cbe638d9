#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace steplab {

/// Notices that files have changed, by looking: in place, or replaced by another file of the same name.
class FileWatch {
public:
    FileWatch() = default;
    /// From how the files are now.
    explicit FileWatch(std::vector<std::filesystem::path> files);

    /// True if any of them is not as it was at the last call. One that is missing, as while an editor replaces it,
    /// counts as unchanged.
    bool changed();

private:
    struct Stamp {
        std::uint64_t device = 0, file = 0, size = 0;
        std::int64_t seconds = 0, nanoseconds = 0;  ///< of the last modification
        bool operator==(const Stamp&) const = default;
    };
    static std::optional<Stamp> stamp_of(const std::filesystem::path& file);

    std::vector<std::filesystem::path> files_;
    std::vector<std::optional<Stamp>> stamps_;
};

}  // namespace steplab
