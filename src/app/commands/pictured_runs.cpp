#include "app/commands/pictured_runs.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "session/compared.hpp"
#include "session/live_costs.hpp"
#include "session/run_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <unistd.h>

namespace steplab {
namespace {

// Samples of the run for the panel's plots; fewer of large scenes, where each takes long.
constexpr std::uint64_t most_samples = 400;
constexpr std::uint64_t most_particle_samples = 20'000'000;

std::uint64_t samples_of(const Simulation& simulation, std::uint64_t steps) {
    const std::uint64_t bound = std::max<std::uint64_t>(16, most_particle_samples / simulation.particles());
    return std::min({steps, most_samples, bound});
}

RunView without_particles(RunView view) {
    view.frame.positions = {};
    view.frame.velocities = {};
    return view;
}

/// Where the leading run ends, at the latest.
double time_of(const RunEnd& end, double dt) { return end.time.value_or(static_cast<double>(end.step) * dt); }

}  // namespace

PicturedRuns::PicturedRuns(const std::vector<RunDescription>& runs, const RunEnd& end, PictureRequest request,
                           std::optional<PicturedEnsemble> ensemble, std::string program)
    : request_(std::move(request)), end_(end), ensemble_(std::move(ensemble)) {
    for (const RunDescription& run : runs) add(run, end.step);
    const Simulation& leading = runs_.front().simulation;
    runs_.front().simulation.end_at(end);
    auto selected = request_.style.selected;
    if (request_.panel && !selected) selected = first_followed(*leading.shape());
    const ParticleList& others = request_.style.selected_too;
    tracked_ = tracked_particles(selected, {others.begin(), others.end()});
    if (request_.panel) samples_ = samples_of(leading, end.step);
    if (ensemble_ && !tracked_.empty()) ensemble_->follow(tracked_.front());
    if (std::any_of(request_.plots.begin(), request_.plots.end(), ui::shows_costs))
        request_.costs = std::make_shared<const CostsView>(costs_of(runs));
    if (request_.panel && runs.size() > 1) {
        for (const Run& run : runs_) errors_.add(run.simulation);
    }
    std::uint64_t steps = 0;
    for (const Run& run : runs_) steps += run.steps.end();
    progress_.emplace(steps, isatty(STDERR_FILENO) != 0, std::move(program));
}

void PicturedRuns::add(const RunDescription& description, std::uint64_t end) {
    Simulation simulation(description);
    const bool leading = runs_.empty();
    if (!leading) end = step_at(time_of(end_, runs_.front().simulation.dt()), simulation.dt());
    runs_.push_back({std::move(simulation), PlausibleSteps(end, [this](std::uint64_t) {
                         check_interruption();
                         std::uint64_t done = 0;
                         for (const Run& run : runs_) done += run.simulation.step();
                         progress_->at(done);
                     })});
}

bool PicturedRuns::go_to(std::uint64_t step) {
    take_samples(step);
    runs_.front().steps.advance(runs_.front().simulation, step);
    follow_leading();
    const std::vector<Place> places = this->places();
    if (places == shown_) return false;
    look();
    shown_ = places;
    return true;
}

/// Takes the others to the time of the leading run.
void PicturedRuns::follow_leading() {
    const double time = runs_.front().simulation.time();
    for (std::size_t i = 1; i < runs_.size(); ++i) {
        Run& run = runs_[i];
        run.steps.advance(run.simulation, std::min(run.steps.end(), step_at(time, run.simulation.dt())));
    }
}

std::vector<const Simulation*> PicturedRuns::simulations() const {
    std::vector<const Simulation*> all;
    for (const Run& run : runs_) all.push_back(&run.simulation);
    return all;
}

/// Those that lie before this step, for the plots.
void PicturedRuns::take_samples(std::uint64_t step) {
    Run& leading = runs_.front();
    for (; sampled_ < samples_ && step_of_sample(sampled_) < step && !is_over(); ++sampled_) {
        leading.steps.advance(leading.simulation, step_of_sample(sampled_));
        if (is_over()) break;
        follow_leading();
        request_.past.push_back(moment());
        if (ensemble_) ensemble_->sample(leading.simulation);
    }
}

PastMoment PicturedRuns::moment() {
    RunView now = view_of(runs_.front().simulation, tracked_);
    const Sample sample = sample_of(now);
    PastMoment moment{.leading = without_particles(std::move(now)), .sample = sample};
    if (runs_.size() == 1) return moment;
    for (std::size_t i = 1; i < runs_.size(); ++i)
        moment.followers.push_back(sample_of(view_of(runs_[i].simulation, tracked_)));
    moment.errors = errors_.of(simulations());
    return moment;
}

/// The same for every picture of a film: at most so many are kept, and no step is taken twice.
std::uint64_t PicturedRuns::step_of_sample(std::uint64_t sample) const { return end_.step * sample / samples_; }

std::vector<PicturedRuns::Place> PicturedRuns::places() const {
    std::vector<Place> places;
    for (const Run& run : runs_) places.push_back({run.simulation.step(), run.simulation.divergence().has_value()});
    return places;
}

/// Puts the runs as they stand now into the request.
void PicturedRuns::look() {
    const Simulation& leading = runs_.front().simulation;
    observe(leading, tracked_, request_.view);
    if (request_.style.forces) leading.forces(request_.view.frame.forces);
    request_.view.frame.magnified = request_.style.displacements;
    if (ensemble_ && request_.panel) ensemble_->sample(leading);
    if (ensemble_) ensemble_->put_into(request_.view);
    request_.followers.resize(runs_.size() - 1);
    for (std::size_t i = 1; i < runs_.size(); ++i) {
        observe(runs_[i].simulation, tracked_, request_.followers[i - 1]);
        request_.followers[i - 1].frame.magnified = request_.style.displacements;
        request_.followers[i - 1].swatch = i;
    }
    std::erase_if(request_.past, [&](const PastMoment& moment) { return moment.leading.frame.step >= leading.step(); });
    if (request_.panel && runs_.size() > 1) request_.errors = errors_.of(simulations());
    if (request_.panel) judge_steps();
}

/// How the steps of the leading run stand to its scene as it is now, and why it diverged.
void PicturedRuns::judge_steps() {
    const Simulation& leading = runs_.front().simulation;
    if (leading.particles() <= PresentLimits::most_particles) {
        request_.present = std::make_shared<const PresentLimit>(
            limits_.at(leading.description(), leading.state(), leading.step(), leading.time()));
        request_.view.frame.oscillation = request_.present->oscillation.shape;
    }
    if (!is_over()) return;
    const std::vector<SegmentBegin> changes{{0, leading.description()}};
    try {
        BlowUpStudy study(changes, *leading.divergence());
        while (study.next()) {
        }
        request_.blow_up = std::make_shared<const BlowUp>(study.found());
        request_.view.frame.oscillation = request_.blow_up->limit.oscillation.shape;
        request_.style.oscillation = true;
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception&) {  // as a rule no memory for another run of it: the picture is without it
    }
}

std::vector<std::string> PicturedRuns::notes() const {
    std::vector<std::string> all = request_.view.notes;
    if (runs_.size() == 1) return all;
    for (std::string& note : all) note.insert(0, "run 0: ");
    for (std::size_t i = 1; i < runs_.size(); ++i) {
        for (const std::string& note : request_.followers[i - 1].notes)
            all.push_back(fmt::format("run {}: {}", i, note));
    }
    return all;
}

void PicturedRuns::check_ends() const {
    if (runs_.size() == 1 && is_over()) throw Error(ExitCode::diverged, request_.view.divergence->message);
    std::string messages;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const auto& divergence = runs_[i].simulation.divergence();
        if (divergence) messages += fmt::format("{}run {}: {}", messages.empty() ? "" : "; ", i, divergence->message);
    }
    if (!messages.empty()) throw Error(ExitCode::diverged, messages);
}

}  // namespace steplab
