#include "lab/study/cost_scan.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "lab/study/gain_watch.hpp"
#include "lab/study/patience.hpp"
#include "lab/study/quick_reference.hpp"
#include "lab/study/speed_error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace steplab {
namespace {

/// Of the first run of a series, and of a scene's own steps over its time.
constexpr double coarsest = 8, usual_steps = 200;
/// Of a reference that is a run: a scan is to begin at once. Where a cut-off keeps it from its order, 16, it gives way
/// to the quick one.
constexpr double reference_effort = 0.1, least_reference_gain = 8;
/// Of the quick reference: some tenths of a second; and where that in long double is no better, some seconds.
constexpr double quick_terms = 1e8, more_terms = 1e9;
/// A first run that takes so many times as long as runs may is put off, and given up if it then takes long, too.
constexpr double patience = 4, last_patience = 200;

/// The runs of one method in one precision, over dt or over tolerances.
struct ScannedSeries {
    std::string method;
    Precision precision = Precision::double_;
    bool by_tolerance = false;
    int level = 0;  ///< of the next run
    bool over = false;
    bool has_run = false;  ///< that did not diverge
    bool put_off = false;  ///< its first run takes long
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
    plan.least_reference_gain = least_reference_gain;
    return plan;
}

}  // namespace

struct CostScan::Body {
    StudyPlan plan;
    std::optional<Reference> reference = {};
    std::vector<ScannedSeries> series = {};
    bool provisional = false;  ///< the reference is a quick one
    std::size_t turn = 0;      ///< of the series to go on with
    double most_seconds;       ///< of a run

    Body(StudyPlan of, double seconds_a_run) : plan(std::move(of)), most_seconds(seconds_a_run) {
        for (const std::string& method : possible_methods(plan)) {
            for (const Precision precision : plan.precisions) {
                if (takes_dt(method)) series.push_back({method, precision});
                if (takes_tolerance(method)) series.push_back({method, precision, true});
            }
        }
    }

    const Reference& known_reference() {
        if (reference) return *reference;
        reference = exact_reference(plan.scene, std::span(&plan.time, 1));
        if (!reference) {
            reference = quick_reference(plan.scene, plan.time, quick_terms);
            provisional = reference.has_value();
        }
        if (!reference) reference = reference_for(plan);
        return *reference;
    }

    /// Once every series has begun: a better reference, if there is one, and the first runs once more.
    void settle_reference() {
        provisional = false;
        if (!is_improved_by(longer_reference()) && !is_improved_by(quick_reference(plan.scene, plan.time, more_terms)))
            return;
        for (ScannedSeries& one : series) {
            if (!one.put_off) one = {one.method, one.precision, one.by_tolerance};
        }
        turn = 0;
    }

    /// None of a scene that is too much for it.
    std::optional<Reference> longer_reference() const try { return reference_for(plan); } catch (const UsageError&) {
        return std::nullopt;
    }

    bool is_improved_by(std::optional<Reference> other) {
        if (!other || !(other->moments.back().error < reference->moments.back().error)) return false;
        reference = std::move(other);
        return true;
    }

    /// The series whose turn it is; null at the end. Those that were put off come when the others are over.
    ScannedSeries* next_series() {
        if (auto* const one = next_of([this](const ScannedSeries& each) {
                return !each.over && !each.put_off && (!provisional || !each.has_run);
            }))
            return one;
        if (provisional) return settle_reference(), next_series();
        return next_of([](const ScannedSeries& each) { return !each.over; });
    }

    template <class Wanted>
    ScannedSeries* next_of(const Wanted& wanted) {
        for (std::size_t tried = 0; tried < series.size(); ++tried) {
            ScannedSeries& one = series[turn];
            turn = (turn + 1) % series.size();
            if (wanted(one)) return &one;
        }
        return nullptr;
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

    /// Notes what it tells of its series. None if it takes too long.
    std::optional<Measurement> taken(ScannedSeries& one) try {
        const Patience until(most_seconds * (one.put_off ? last_patience : patience));
        Measurement result = measure(run_of(one), steps_of(one), known_reference(), check_interruption);
        const double growth = one.by_tolerance ? 1.5 : 2;
        const double least_tolerance = one.precision == Precision::float_ ? 1e-7 : 1e-15;
        ++one.level;
        one.has_run = one.has_run || !result.diverged();
        one.over = one.gain.gains_no_more(result) || result.rough_seconds * growth > most_seconds ||
                   (one.by_tolerance && std::pow(10.0, -2 - one.level) < least_tolerance) || one.level > 40;
        return result;
    } catch (const PatienceEnds&) {
        one.over = one.put_off || one.level > 0;
        one.put_off = true;
        return std::nullopt;
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

bool CostScan::provisional() const { return body_->provisional; }

std::string CostScan::how() const { return body_->reference ? body_->reference->how : ""; }

std::optional<CostPoint> CostScan::next() {
    body_->known_reference();
    while (ScannedSeries* const one = body_->next_series()) {
        const auto result = body_->taken(*one);
        auto point = result ? point_of(result->run, *result) : std::nullopt;
        if (!point) continue;
        point->provisional = body_->provisional;
        return point;
    }
    return std::nullopt;
}

std::optional<CostPoint> CostScan::cost_of(const RunDescription& run) {
    const bool own_steps = chooses_its_steps(run);
    const auto steps = own_steps ? 1 : static_cast<std::uint64_t>(std::max(1.0, std::ceil(time() / std::abs(run.dt))));
    RunDescription over = run;
    over.dt = time() / static_cast<double>(steps);
    const Measurement result = measure(over, steps, body_->known_reference(), check_interruption);
    auto point = point_of(run, result);
    if (point) point->provisional = body_->provisional;
    return point;
}

double CostScan::done() const {
    const auto& all = body_->series;
    if (body_->provisional) return 0;
    const auto over = std::count_if(all.begin(), all.end(), [](const ScannedSeries& one) { return one.over; });
    return all.empty() ? 1 : static_cast<double>(over) / static_cast<double>(all.size());
}

void put(std::vector<CostPoint>& points, CostPoint point) {
    const auto before = std::find_if(points.begin(), points.end(),
                                     [&](const CostPoint& each) { return each.provisional && each.run == point.run; });
    before != points.end() ? * before = std::move(point) : points.emplace_back(std::move(point));
}

}  // namespace steplab
