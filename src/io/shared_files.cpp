#include "io/shared_files.hpp"

#include "core/installed_folders.hpp"

#include <algorithm>
#include <system_error>

namespace steplab {

std::vector<std::filesystem::path> shared_folders(const std::string& name) {
    std::vector<std::filesystem::path> folders = installed_folders(name);
    folders.push_back(std::filesystem::path(STEPLAB_ASSETS_IN_SOURCE) / name);
    return folders;
}

std::filesystem::path shared_file(const std::string& folder, const std::string& name) {
    for (const auto& place : shared_folders(folder)) {
        std::error_code error;
        if (std::filesystem::exists(place / name, error)) return place / name;
    }
    return {};
}

std::vector<std::string> shared_names(const std::string& folder, const std::string& ending) {
    std::vector<std::string> names;
    for (const auto& place : shared_folders(folder)) {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(place, error)) {
            if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
        }
        if (!names.empty()) break;
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace steplab
