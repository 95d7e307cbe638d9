#include "io/file_watch.hpp"

#include <sys/stat.h>
#include <utility>

namespace steplab {

FileWatch::FileWatch(std::vector<std::filesystem::path> files) : files_(std::move(files)) {
    for (const auto& file : files_) stamps_.push_back(stamp_of(file));
}

bool FileWatch::changed() {
    bool any = false;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        const std::optional<Stamp> now = stamp_of(files_[i]);
        if (!now || now == stamps_[i]) continue;
        stamps_[i] = now;
        any = true;
    }
    return any;
}

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::filesystem::path& file) {
    struct stat found {};
    if (stat(file.c_str(), &found) != 0) return std::nullopt;
    return Stamp{.device = static_cast<std::uint64_t>(found.st_dev),
                 .file = static_cast<std::uint64_t>(found.st_ino),
                 .size = static_cast<std::uint64_t>(found.st_size),
                 .seconds = static_cast<std::int64_t>(found.st_mtim.tv_sec),
                 .nanoseconds = static_cast<std::int64_t>(found.st_mtim.tv_nsec)};
}

}  // namespace steplab
