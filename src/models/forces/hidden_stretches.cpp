#include "models/forces/hidden_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

class HiddenSearch {
public:
    HiddenSearch(const ExpressionForce& force, const RangeOfPairs& pairs) : factor_(force.force), pairs_(pairs) {}

    void look_between(double from, double to) {
        const double there = most(from, from), here = most(to, to);
        shown_ = ApproachTable::growth * std::max(there, here);
        look({from, there}, {to, here}, 0);
    }
    std::vector<HiddenStretch> found() { return std::move(found_); }

private:
    struct End {
        double distance, value;
    };
    static constexpr int deepest = 12;               ///< a step of the table is halved so often
    static constexpr std::size_t patience = 50'000;  ///< bounds: then what may hide in a step counts as found
    static constexpr double nothing = 1e-200;

    /// Not less than |F| r at any of these distances.
    double most(double from, double to) {
        ++bounds_;
        const double bound = factor_(Interval(from * from, to * to), pairs_).largest() * to * to;
        return std::isnan(bound) ? std::numeric_limits<double>::max()
                                 : std::min(bound, std::numeric_limits<double>::max());
    }

    void look(End low, End high, int depth) {
        const double bound = most(low.distance, high.distance), known = std::max(low.value, high.value);
        if (bound <= shown_ || bound < nothing) return;
        const bool is_narrow = depth == deepest || bounds_ > patience;
        if (bound <= ApproachTable::growth * known || is_narrow) {
            if (known > shown_ || is_narrow) add(low.distance, high.distance, is_narrow ? bound : known);
            return;
        }
        const double middle = low.distance + (high.distance - low.distance) / 2;
        const End between{middle, most(middle, middle)};
        look(low, between, depth + 1);
        look(between, high, depth + 1);
    }

    /// Those that touch are one.
    void add(double from, double to, double weight) {
        if (found_.empty() || found_.back().to < from) return found_.push_back({from, to, weight});
        found_.back().to = to;
        found_.back().weight = std::max(found_.back().weight, weight);
    }

    ExpressionFactors<double, Interval> factor_;
    RangeOfPairs pairs_;
    double shown_ = 0;
    std::size_t bounds_ = 0;
    std::vector<HiddenStretch> found_;
};

}  // namespace

std::vector<HiddenStretch> hidden_stretches(const ExpressionForce& force, const RangeOfPairs& pairs, double cutoff) {
    HiddenSearch search(force, pairs);
    ApproachTable::each_step([&](double from, double to) {
        if (cutoff == 0 || from < cutoff) search.look_between(from, cutoff > 0 ? std::min(to, cutoff) : to);
    });
    return search.found();
}

}  // namespace steplab
