#include "lab/report/report.hpp"

#include "io/folder_lock.hpp"
#include "io/output_file.hpp"
#include "lab/limits/all_limits.hpp"
#include "lab/report/report_page.hpp"
#include "lab/study/saved_study.hpp"
#include "lab/study/speed_error_csv.hpp"
#include "lab/study/thesis.hpp"

#include <filesystem>
#include <utility>

namespace steplab {

namespace {

/// The share of the series in the time of a study; the limits take the rest.
constexpr double share_of_series = 0.85;

/// The limits of all methods of the plan, in its first precision; for a method that cannot run the scene, the reason.
std::vector<Limit> limits_of(const StudyPlan& plan, const StudyProgress& progress) {
    const Precision precision = plan.precisions.front();
    const StabilityLab lab(run_over(plan, "rk4", precision, 1), plan.brief ? NoLimit::by_theory : NoLimit::measured);
    std::vector<RunDescription> methods;
    for (const std::string& id : plan.methods) {
        methods.push_back(run_over(plan, id, precision, 1));
        methods.back().dt = plan.scene.dt;
    }
    return all_limits(lab, methods, [&](std::size_t found) {
        progress(static_cast<double>(found) / static_cast<double>(methods.size()));
    });
}

/// References take long where many particles interact.
Reference watched_reference(const StudyPlan& plan, const StudyProgress& progress) {
    return reference_for(plan, 0, [&](int, double) { progress(0); });
}

Study measured(const StudyPlan& plan, const SavedStudies& saved, const StudyProgress& progress) {
    StudyState state = saved.find(plan).value_or(StudyState{});
    const auto save = [&] { saved.save(plan, state); };
    if (!state.series.timed) {
        const Reference reference = watched_reference(plan, progress);
        state.reference = reference.how;
        state.reference_error = reference.moments.back().error;
        continue_series(plan, reference, state.series, save, [&](double part) { progress(share_of_series * part); });
    }
    if (!state.limits) {
        state.limits = limits_of(plan, [&](double part) { progress(share_of_series + (1 - share_of_series) * part); });
        save();
    }
    return {.plan = plan,
            .reference = state.reference,
            .reference_error = state.reference_error,
            .runs = std::move(state.series.runs),
            .cut = std::move(state.series.cut),
            .limits = std::move(*state.limits)};
}

void write_file(const std::string& folder, const char* name, const std::string& text) {
    OutputFile file((std::filesystem::path(folder) / name).string());
    file.write(text);
    file.commit();
}

}  // namespace

void write_report(const ReportRequest& request, const ReportProgress& progress) {
    const SavedStudies saved(request.folder);
    const FolderLock lock(request.folder, "another report is being written");
    std::vector<Study> studies;
    std::vector<Measurement> all;
    double work = 0, done = 0;
    for (const StudyPlan& plan : request.plans) work += share_of_work(plan);
    for (const StudyPlan& plan : request.plans) {
        const double share = share_of_work(plan);
        const auto report_progress = [&](double part) { progress((done + share * part) / work, plan.scene.model); };
        report_progress(0);
        studies.push_back(measured(plan, saved, report_progress));
        all.insert(all.end(), studies.back().runs.begin(), studies.back().runs.end());
        done += share;
    }
    write_file(request.folder, "speed_error.csv", speed_error_csv(all));
    write_file(request.folder, "report.html", report_page(studies, request.errors, circumstances()));
    saved.remove();
}

void write_thesis_page(const std::string& folder) {
    make_folder(folder);
    write_file(folder, "thesis.html", thesis_page());
}

}  // namespace steplab
