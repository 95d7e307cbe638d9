#include "lab/study/cost_scan.hpp"

#include "core/interruption.hpp"
#include "lab/study/gain_watch.hpp"
#include "lab/study/speed_error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplab {
namespace {

/// Of the first run of a series, and of a scene's own steps over its time.
constexpr double coarsest = 8, usual_steps = 200;
/// Of a reference that is a run: a scan is to begin at once.
constexpr double reference_effort = 0.1;

/// The runs of one method in one precision, over dt or over tolerances.
struct ScannedSeries {
    std::string method;
    Precision precision = Precision::double_;
    bool by_tolerance = false;
    int level = 0;  ///< of the next run
    bool over = false;
    double seconds = 0;  ///< that the last run took
    GainWatch gain = {};
};

StudyPlan plan_of_scan(const RunDescription& scene, double time) {
    StudyPlan plan;
    plan.scene = scene;
    plan.time = time;
    plan.precisions = {Precision::double_, Precision::float_};
    for (const Method& method : methods()) {
        if (!method.info.curiosity) plan.methods.emplace_back(method.info.id);
    }
    plan.reference_effort = reference_effort;
    return plan;
}

}  // namespace

struct CostScan::Body {
    StudyPlan plan;
    std::optional<Reference> reference = {};
    std::vector<ScannedSeries> series = {};
    std::size_t turn = 0;  ///< of the series to go on with
    double most_seconds;   ///< of a run

    Body(StudyPlan of, double seconds_a_run) : plan(std::move(of)), most_seconds(seconds_a_run) {
        for (const std::string& method : possible_methods(plan)) {
            for (const Precision precision : plan.precisions) {
                if (takes_dt(method)) series.push_back({method, precision});
                if (takes_tolerance(method)) series.push_back({method, precision, true});
            }
        }
    }

    const Reference& known_reference() {
        if (!reference) reference = reference_for(plan);
        return *reference;
    }

    std::uint64_t steps_of(const ScannedSeries& one) const {
        if (one.by_tolerance) return 1;
        const double usual = std::max(1.0, std::ceil(plan.time / opening_dt(plan.scene) / coarsest));
        return static_cast<std::uint64_t>(std::ldexp(usual, one.level));
    }

    RunDescription run_of(const ScannedSeries& one) const {
        RunDescription run = run_over(plan, one.method, one.precision, steps_of(one));
        if (one.by_tolerance) run.method_parameters.set("tolerance", std::pow(10.0, -2 - one.level));
        return run;
    }

    /// Notes what it tells of its series.
    Measurement taken(ScannedSeries& one) {
        const double least_tolerance = one.precision == Precision::float_ ? 1e-7 : 1e-15;
        const RunDescription run = run_of(one);
        Measurement result = measure(run, steps_of(one), known_reference(), check_interruption);
        const double growth = one.by_tolerance ? 1.5 : 2;
        ++one.level;
        one.over = one.gain.gains_no_more(result) || result.rough_seconds * growth > most_seconds ||
                   (one.by_tolerance && std::pow(10.0, -2 - one.level) < least_tolerance) || one.level > 40;
        return result;
    }
};

namespace {

/// Of a short run the least of several times: in one alone, what else the machine does is most of it.
double seconds_of(const Measurement& measured) {
    constexpr double short_time = 3e-4;
    constexpr int again = 4;
    double least = measured.rough_seconds;
    for (int i = 0; i < again && measured.rough_seconds < short_time; ++i)
        least = std::min(least, stepping_seconds(measured.run, measured.steps));
    return least;
}

/// None of one that diverged. `run`: as it is told.
std::optional<CostPoint> point_of(const RunDescription& run, const Measurement& measured) {
    if (measured.diverged() || !std::isfinite(measured.error)) return std::nullopt;
    return CostPoint{run, static_cast<double>(measured.result.evaluations), measured.error, seconds_of(measured)};
}

}  // namespace

CostScan::CostScan(const RunDescription& scene, std::optional<double> time, double seconds_a_run)
    : body_(std::make_unique<Body>(plan_of_scan(scene, time.value_or(time_for(scene))), seconds_a_run)) {}
CostScan::~CostScan() = default;
CostScan::CostScan(CostScan&&) noexcept = default;
CostScan& CostScan::operator=(CostScan&&) noexcept = default;

double CostScan::time_for(const RunDescription& scene) {
    return model_of(scene).opening.until.value_or(usual_steps * opening_dt(scene));
}

double CostScan::time() const { return body_->plan.time; }

std::string CostScan::how() const { return body_->reference ? body_->reference->how : ""; }

std::optional<CostPoint> CostScan::next() {
    auto& all = body_->series;
    while (std::any_of(all.begin(), all.end(), [](const ScannedSeries& one) { return !one.over; })) {
        ScannedSeries& one = all[body_->turn];
        body_->turn = (body_->turn + 1) % all.size();
        if (one.over) continue;
        const Measurement result = body_->taken(one);
        if (auto point = point_of(result.run, result)) return point;
    }
    return std::nullopt;
}

std::optional<CostPoint> CostScan::cost_of(const RunDescription& run) {
    const bool own_steps = chooses_its_steps(run);
    const auto steps = own_steps ? 1 : static_cast<std::uint64_t>(std::max(1.0, std::ceil(time() / std::abs(run.dt))));
    RunDescription over = run;
    over.dt = time() / static_cast<double>(steps);
    const Measurement result = measure(over, steps, body_->known_reference(), check_interruption);
    return point_of(run, result);
}

double CostScan::done() const {
    const auto& all = body_->series;
    const auto over = std::count_if(all.begin(), all.end(), [](const ScannedSeries& one) { return one.over; });
    return all.empty() ? 1 : static_cast<double>(over) / static_cast<double>(all.size());
}

}  // namespace steplab
