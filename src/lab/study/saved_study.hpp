#pragma once

#include "lab/study/study.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace steplab {

/// A study under way: what is measured of it so far.
struct StudyState {
    std::string reference;
    double reference_error = 0;
    SeriesState series;
    std::optional<std::vector<Limit>> limits;  ///< none: not yet
};

/// Studies under way, a file for each in a folder of their own, so that a report which was interrupted goes on where it
/// was. What is not whole, or was made by another plan, program or machine, counts for nothing.
class KeptStudies {
public:
    /// In the folder of a report, which is made if it is not there. Throws FileError.
    explicit KeptStudies(const std::string& report_folder);

    std::optional<StudyState> find(const StudyPlan& plan) const;
    void keep(const StudyPlan& plan, const StudyState& state) const;
    /// The report is complete.
    void forget() const;

private:
    std::string file_of(const StudyPlan& plan) const;

    std::filesystem::path folder_;
};

/// Makes a folder and those it lies in. Throws FileError.
void make_folder(const std::filesystem::path& folder);

}  // namespace steplab
