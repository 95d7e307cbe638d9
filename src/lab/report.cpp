#include "lab/report.hpp"

#include "core/error.hpp"
#include "io/output_file.hpp"
#include "lab/report_page.hpp"
#include "lab/speed_error_csv.hpp"
#include "lab/thesis.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>

namespace steplab {

namespace {

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
}

/// Measurements of the scenes that are done, each in a file of its own until the whole report is.
class DoneScenes {
public:
    explicit DoneScenes(const std::string& folder) : folder_(std::filesystem::path(folder) / ".measured") {
        make_folder(folder_);
    }

    std::optional<std::vector<Measurement>> find(const StudyPlan& plan) const {
        std::ifstream file(file_of(plan));
        std::string first;
        if (!file || !std::getline(file, first) || first != key(plan)) return std::nullopt;
        std::ostringstream rest;
        rest << file.rdbuf();
        return parse_speed_error_csv(rest.str());
    }

    void keep(const StudyPlan& plan, const std::vector<Measurement>& runs) const {
        OutputFile file(file_of(plan));
        file.write(key(plan) + "\n" + speed_error_csv(runs));
        file.commit();
    }

    void forget() const {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

private:
    std::string file_of(const StudyPlan& plan) const { return (folder_ / (plan.scene.model + ".csv")).string(); }

    /// Everything that makes measurements comparable: the plan, the program and the machine.
    static std::string key(const StudyPlan& plan) {
        const Circumstances made = circumstances();
        std::string text = fmt::format("{} to {} with", command_line(plan.scene), plan.time);
        for (const std::string& method : plan.methods) text += " " + method;
        for (const Precision precision : plan.precisions) text += fmt::format(" {}", id(precision));
        return text + fmt::format(" {} {} {} by {} {} on {}", plan.most_seconds_a_run, plan.ratio, plan.rounds,
                                  made.commit, made.compiler, made.processor);
    }

    std::filesystem::path folder_;
};

void write_file(const std::string& folder, const char* name, const std::string& text) {
    OutputFile file((std::filesystem::path(folder) / name).string());
    file.write(text);
    file.commit();
}

}  // namespace

void write_report(const ReportRequest& request, const ReportProgress& progress) {
    const DoneScenes done(request.folder);
    std::vector<Study> studies;
    std::vector<Measurement> all;
    const double parts = static_cast<double>(request.plans.size());
    for (const StudyPlan& plan : request.plans) {
        const double before = static_cast<double>(studies.size());
        const auto tell = [&](double part) { progress((before + part) / parts, plan.scene.model); };
        tell(0);
        Study study{plan, reference_for(plan), {}};
        auto known = done.find(plan);
        study.runs = known ? std::move(*known) : measure_series(plan, study.reference, tell);
        if (!known) done.keep(plan, study.runs);
        all.insert(all.end(), study.runs.begin(), study.runs.end());
        studies.push_back(std::move(study));
    }
    write_file(request.folder, "speed_error.csv", speed_error_csv(all));
    write_file(request.folder, "report.html", report_page(studies, request.errors, circumstances()));
    done.forget();
}

void write_thesis_page(const std::string& folder) {
    make_folder(folder);
    write_file(folder, "thesis.html", thesis_page());
}

}  // namespace steplab
