#pragma once

#include "lab/study/study.hpp"

#include <string>
#include <vector>

namespace steplab {

/// The contents of a report and its folder.
struct ReportRequest {
    std::string folder;  ///< created if it does not exist
    std::vector<StudyPlan> plans;
    std::vector<double> errors{1e-2, 1e-4,  1e-6,
                               1e-8, 1e-10, 1e-12};  ///< accuracies for which it names the fastest run
};

/// Called with the fraction of a report that is done, 0 .. 1, and what is being measured; may throw to end it.
using ReportProgress = std::function<void(double, const std::string&)>;

/// Measures every plan and writes speed_error.csv and report.html into the folder. Measurements are saved there during
/// the work: an interrupted report is resumed when it is requested again. Throws FileError, also
/// if another report is being written into the folder.
void write_report(const ReportRequest& request, const ReportProgress& progress);

/// Writes thesis.html into the folder: the tables and charts of the thesis, recomputed. Throws FileError.
void write_thesis_page(const std::string& folder);

}  // namespace steplab
