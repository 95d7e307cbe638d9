#pragma once

#include "lab/study/study.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace steplab {

/// The measurements so far of an unfinished study.
struct StudyState {
    std::string reference;
    double reference_error = 0;
    SeriesState series;
    std::optional<std::vector<Limit>> limits;  ///< nullopt: not measured yet
};

/// Unfinished studies, one file each in a folder of their own, so that an interrupted report can be resumed. Files that
/// are incomplete, or were written for another plan, program or machine, are ignored.
class SavedStudies {
public:
    /// In the folder of a report, which is created if it does not exist. Throws FileError.
    explicit SavedStudies(const std::string& report_folder);

    std::optional<StudyState> find(const StudyPlan& plan) const;
    void save(const StudyPlan& plan, const StudyState& state) const;
    /// Removes all of them: the report is complete.
    void remove() const;

private:
    std::string file_of(const StudyPlan& plan) const;

    std::filesystem::path folder_;
};

/// Creates a folder and its parents. Throws FileError.
void make_folder(const std::filesystem::path& folder);

}  // namespace steplab
