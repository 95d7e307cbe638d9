#pragma once

#include "core/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace steplab {

/// A new, empty folder, which is deleted with all its contents when this object is destroyed.
class TemporaryFolder {
public:
    /// Throws FileError if it cannot be created.
    TemporaryFolder() {
        std::error_code error;
        const std::filesystem::path place = std::filesystem::temp_directory_path(error);
        path_ = (place / "steplab-XXXXXX").string();
        if (error || mkdtemp(path_.data()) == nullptr)
            throw FileError("cannot create a temporary folder: TMPDIR must name a folder that can be written");
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }
    std::string file(std::string_view name) const { return path_ + '/' + std::string(name); }
    bool empty() const { return std::filesystem::is_empty(path_); }

private:
    std::string path_;
};

}  // namespace steplab
