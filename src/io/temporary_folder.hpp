#pragma once

#include "core/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace steplab {

/// A new, empty folder, which is deleted with all its contents when this object is destroyed, unless it is kept.
class TemporaryFolder {
public:
    /// Where temporary files belong. Throws FileError if it cannot be created.
    TemporaryFolder() {
        std::error_code error;
        const std::filesystem::path place = std::filesystem::temp_directory_path(error);
        if (error || !make(place / "steplab-"))
            throw FileError("cannot create a temporary folder: TMPDIR must name a folder that can be written");
    }
    /// In the folder of the program, its name beginning so. Throws FileError.
    explicit TemporaryFolder(const std::string& name) {
        if (!make(name)) throw FileError("cannot create a folder " + name + "... here: choose one that can be written");
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!kept_) std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    void keep() { kept_ = true; }
    const std::string& path() const { return path_; }
    std::string file(std::string_view name) const { return path_ + '/' + std::string(name); }
    bool empty() const { return std::filesystem::is_empty(path_); }

private:
    bool make(const std::filesystem::path& begin) {
        path_ = begin.string() + "XXXXXX";
        return mkdtemp(path_.data()) != nullptr;
    }

    std::string path_;
    bool kept_ = false;
};

}  // namespace steplab
