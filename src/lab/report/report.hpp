#pragma once

#include "lab/study/study.hpp"

#include <string>
#include <vector>

namespace steplab {

/// What a report is to hold and where it goes.
struct ReportRequest {
    std::string folder;  ///< made if it is not there
    std::vector<StudyPlan> plans;
    std::vector<double> errors{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};  ///< accuracies it answers for
};

/// The part of a report that is done, 0 .. 1, and what is being measured; may throw to end it.
using ReportProgress = std::function<void(double, const std::string&)>;

/// Measures every plan and writes speed_error.csv and report.html into the folder. What is measured is kept there scene
/// by scene: a report that was interrupted and is asked for again goes on where it was. Throws FileError.
void write_report(const ReportRequest& request, const ReportProgress& progress);

/// Writes thesis.html into the folder: the thesis' tables and charts, recomputed. Throws FileError.
void write_thesis_page(const std::string& folder);

}  // namespace steplab
