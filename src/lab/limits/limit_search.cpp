#include "lab/limits/limit_search.hpp"

#include "core/entry.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace steplab {

namespace {

constexpr double resolution = 3e-5;  // relative, of the bisection

using Grows = std::function<bool(const GrowthQuestion&)>;

/// Bisection on runs, starting at the limit of theory.
class Bisection {
public:
    Bisection(const LimitSearch& search, Grows grows) : search_(search), grows_(std::move(grows)) {}

    double limit() const {
        double expected = search_.expected;
        if (!(expected >= 0))
            throw UsageError(
                "the search for a stability limit needs a frequency of the scene, and none is known: choose a scene "
                "closer to equilibrium");
        if (expected == infinity) return beyond_all();
        if (expected == 0) {
            // detected soonest at dt far below the usual ones: midpoint grows by (omega dt)^4 / 8 per step
            if (grows_({.dt = 0.1 * search_.time_scale, .steps = 8192, .allowed = 0.01})) return 0;
            expected = search_.time_scale;
        }
        double stable = 0.99 * expected;
        const double least = 0.01 * std::min(stable, search_.time_scale);
        for (; grows(stable); stable *= 0.8) {
            if (stable < least) return 0;
        }
        return up_from(stable, expected);
    }

private:
    bool grows(double dt) const { return grows_({.dt = dt, .steps = search_.steps}); }

    double up_from(double stable, double expected) const {
        if (search_.above > stable && grows(search_.above)) return between(stable, search_.above);
        for (double dt = std::max(stable, 1.01 * expected); dt < 1e4 * search_.time_scale; dt *= 1.25) {
            if (grows(dt)) return between(stable, dt);
            stable = dt;
        }
        return infinity;
    }

    /// For a method that should be stable at any dt: tests some values far beyond the limits of explicit methods.
    double beyond_all() const {
        double stable = 0.1 * search_.time_scale;
        for (const double tried : {1.0, 3.0, 10.0, 100.0, 1000.0}) {
            const double dt = tried * search_.time_scale;
            if (grows_({.dt = dt, .steps = search_.steps_beyond})) return between(stable, dt);
            stable = dt;
        }
        return infinity;
    }

    double between(double stable, double unstable) const {
        while (unstable - stable > resolution * unstable) {
            const double middle = (stable + unstable) / 2;
            (grows(middle) ? unstable : stable) = middle;
        }
        return (stable + unstable) / 2;
    }

    const LimitSearch& search_;
    Grows grows_;
};

/// Probability that a vibration grows at dt if theory is approximately right, given that it is stable at `stable` and
/// grows at `unstable`.
double likelihood_of_growth(double dt, double expected, double stable, double unstable) {
    constexpr double sure = 0.95,
                     about = 1e-4;  // this close to the limit a bounded vibration may be mistaken for a growing one
    if (expected <= stable || expected >= unstable || std::abs(dt - expected) < about * expected) return 0.5;
    return dt > expected ? sure : 1 - sure;
}

/// A possible continuation of the search: supposed answers to open questions.
struct Branch {
    std::vector<bool> answers;
    double likelihood = 1;
};

/// The search so far, and its possible continuations.
class Outlook {
public:
    explicit Outlook(const LimitSearch& search) : search_(search) {}

    void add(const GrowthQuestion& answered) { known_.push_back(answered); }

    /// The most likely of the next questions, the very next one first; empty if the limit is known.
    std::vector<GrowthQuestion> questions(std::size_t most) {
        std::vector<GrowthQuestion> likeliest;
        std::vector<Branch> branches{{}};
        while (!branches.empty() && likeliest.size() < most) {
            const Branch branch = take_likeliest(branches);
            const Next next = follow(branch);
            if (!next.question) continue;
            if (!find(likeliest, *next.question)) likeliest.push_back(*next.question);
            for (const bool grows : {true, false}) {
                Branch further = branch;
                further.answers.push_back(grows);
                further.likelihood *= grows ? next.growth : 1 - next.growth;
                branches.push_back(std::move(further));
            }
        }
        return likeliest;
    }

    double limit() { return follow({}).limit; }

private:
    struct Next {
        double limit;  ///< valid if there is no question
        std::optional<GrowthQuestion> question;
        double growth;  ///< probability that it grows
    };

    static Branch take_likeliest(std::vector<Branch>& branches) {
        const auto best = std::max_element(branches.begin(), branches.end(), [](const Branch& a, const Branch& b) {
            return a.likelihood < b.likelihood;
        });
        Branch taken = std::move(*best);
        branches.erase(best);
        return taken;
    }

    static const GrowthQuestion* find(const std::vector<GrowthQuestion>& among, const GrowthQuestion& question) {
        const auto found =
            std::find_if(among.begin(), among.end(), [&](const auto& other) { return other.same(question); });
        return found == among.end() ? nullptr : &*found;
    }

    /// The first question without an answer in this continuation.
    Next follow(const Branch& branch) const {
        Next next{};
        double stable = 0, unstable = infinity;
        std::size_t supposed = 0;
        next.limit = Bisection(search_, [&](const GrowthQuestion& question) {
                         if (next.question) return true;  // ends the bisection quickly
                         const GrowthQuestion* const known = find(known_, question);
                         if (!known && supposed == branch.answers.size()) {
                             next.question = question;
                             next.growth = likelihood_of_growth(question.dt, search_.expected, stable, unstable);
                             return true;
                         }
                         const bool grows = known ? *known->grows : branch.answers[supposed++];
                         if (grows) unstable = std::min(unstable, question.dt);
                         if (!grows) stable = std::max(stable, question.dt);
                         return grows;
                     }).limit();
        return next;
    }

    const LimitSearch& search_;
    std::vector<GrowthQuestion> known_;
};

}  // namespace

double LimitSearch::limit(const Grows& grows) const { return Bisection(*this, grows).limit(); }

double LimitSearch::limit(std::size_t most, const std::function<void(std::span<GrowthQuestion>)>& answer) const {
    Outlook outlook(*this);
    for (;;) {
        std::vector<GrowthQuestion> questions = outlook.questions(most);
        if (questions.empty()) return outlook.limit();
        answer(questions);
        for (const GrowthQuestion& question : questions) {
            if (question.grows) outlook.add(question);
        }
    }
}

}  // namespace steplab
