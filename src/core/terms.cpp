#include "core/terms.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace steplab {

namespace {

constexpr std::array all_terms{
    Term{"dt",
         "The time step: how much simulated time passes from one computed state to the next. Half the dt costs "
         "twice as many steps and makes the error smaller, by how much depends on the order.",
         "time step|step size"},
    Term{"order",
         "How fast the error falls with dt: with order p, half the dt makes it 2^p times smaller. It says "
         "nothing about how large the error is at a given dt.",
         "orders"},
    Term{"force evaluations",
         "How often the forces of all particles are computed: the cost of a method that does not "
         "depend on the computer. Methods are compared fairly at equal force evaluations.",
         "evaluation|evaluations|force evaluation"},
    Term{"energy error",
         "Energy of the run minus its energy at the start. It needs no exact solution, but a small one "
         "does not mean that the positions are right.",
         "energy errors|energy drift"},
    Term{"position error",
         "Largest distance of a particle from where it should be at that time: from the exact "
         "solution, or from a reference.",
         "position errors|largest error"},
    Term{"phase error",
         "The time by which a run is ahead of the true motion or behind it. An orbit can have the right "
         "shape and the wrong timing.",
         "phase"},
    Term{"momentum error",
         "Change of the total momentum since the start. Forces between particles keep it, so any "
         "change is rounding or a wrong force.",
         "momentum"},
    Term{"exact solution", "The motion as a formula, known for a few scenes only, such as masses on springs.", "exact"},
    Term{"reference",
         "A run so accurate that it stands in for the exact solution: high order, small steps, extended "
         "precision. Its own error is estimated from two such runs.",
         "reference run|reference solution"},
    Term{"correct digits",
         "How many leading decimal digits of a result are right: an error of 0.001 of the value "
         "leaves 3 of them.",
         "digits"},
    Term{"stability limit",
         "The largest dt at which errors of a method do not grow without bound. For explicit methods "
         "it is a number of the method divided by the fastest angular frequency of the scene.",
         "limit|stable|unstable|diverged|diverges|stability"},
    Term{"steps per period",
         "Number of steps in one period of the fastest oscillation. Below about 10 the oscillation "
         "itself is not computed accurately, even if nothing blows up.",
         "per period"},
    Term{"symplectic",
         "Each step keeps the geometry of mechanics (areas in the plane of position and momentum). The "
         "energy error then stays bounded over very long times instead of growing.",
         ""},
    Term{"time-reversible",
         "With all velocities reversed, the method takes the same way back. Such a method has no "
         "built-in direction of time, and its energy does not drift in regular motion.",
         "reversible|reversed"},
    Term{"explicit",
         "The next state is computed directly from forces that are known: cheap, but stable only below a "
         "largest dt.",
         "explicit methods"},
    Term{"implicit",
         "The next state is found by solving an equation that contains its own force. A step costs more, "
         "but the dt can be far above the stability limit of explicit methods.",
         ""},
    Term{"stiff",
         "A scene with oscillations much faster than the motion of interest. Explicit methods must resolve "
         "them, implicit ones can step over them.",
         "stiffness"},
    Term{"numerical damping",
         "Energy that the method takes away although the scene has no friction. Wanted for fast "
         "oscillations that only disturb, wrong for the motion itself.",
         "damping"},
    Term{"adaptive",
         "The method chooses its steps itself: short where the motion is fast, long where it is slow. dt is "
         "then only the spacing of the states that are shown.",
         ""},
    Term{"tolerance",
         "The error per step that an adaptive method accepts; it takes the longest steps that keep below "
         "it. The error at the end can be larger, as errors add up.",
         ""},
    Term{"precision", "Number of digits with which the run computes: float about 7 decimal digits, double about 16.",
         "float|double"},
    Term{"rounding",
         "Every result is cut to the digits of the precision. The cuts add up with the number of steps, so "
         "below some dt the error grows again.",
         "rounding error|rounding errors"},
    Term{"compensated",
         "Sums keep what rounding cuts off and add it later (Kahan summation): rounding errors grow much "
         "more slowly, at little cost.",
         "kahan"},
    Term{"conditioning",
         "How strongly the result depends on small changes of the start. Where it is bad, no method "
         "can be accurate: the start itself is not known well enough.",
         "ill-conditioned|conditioned"},
    Term{"chaos",
         "Neighbouring motions part exponentially. After some Lyapunov times two runs have nothing in common, "
         "whatever the method; averages can still be right.",
         "chaotic"},
    Term{"Lyapunov time",
         "The time in which the distance of two neighbouring motions grows by a factor e = 2.718. One "
         "more correct digit at the start delays the loss by only 2.3 of them.",
         "lyapunov|lyapunov times"},
    Term{"twin", "The same run in the other precision beside it: where they differ, rounding matters.", ""},
    Term{"equal cost",
         "Every run gets the dt at which it spends as many force evaluations per simulated second as the "
         "leading one: the fair comparison of methods.",
         "equal force evaluations"},
};

bool is_part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; }

/// Where a word stands in a text, whole; npos if it does not.
std::size_t place_of(std::string_view text, std::string_view word) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    auto from = text.begin();
    while (!word.empty()) {
        const auto found = std::search(from, text.end(), word.begin(), word.end(), same);
        if (found == text.end()) break;
        const auto end = found + static_cast<std::ptrdiff_t>(word.size());
        const bool begins = found == text.begin() || !is_part_of_word(*(found - 1));
        if (begins && (end == text.end() || !is_part_of_word(*end)))
            return static_cast<std::size_t>(found - text.begin());
        from = found + 1;
    }
    return std::string_view::npos;
}

/// Of the first of its forms in the text.
std::size_t place_of(std::string_view text, const Term& term) {
    std::size_t first = place_of(text, term.id);
    for (std::string_view rest = term.words; !rest.empty();) {
        const std::size_t bar = std::min(rest.find('|'), rest.size());
        first = std::min(first, place_of(text, rest.substr(0, bar)));
        rest.remove_prefix(std::min(bar + 1, rest.size()));
    }
    return first;
}

}  // namespace

std::span<const Term> terms() { return all_terms; }

const Term* find_term(std::string_view id) {
    const auto found =
        std::find_if(all_terms.begin(), all_terms.end(), [&](const Term& term) { return term.id == id; });
    return found == all_terms.end() ? nullptr : &*found;
}

bool mentions(std::string_view text, const Term& term) { return place_of(text, term) != std::string_view::npos; }

std::string explanations(std::string_view text) {
    std::vector<std::pair<std::size_t, const Term*>> found;
    for (const Term& term : all_terms) {
        const std::size_t place = place_of(text, term);
        if (place != std::string_view::npos) found.emplace_back(place, &term);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string lines;
    for (const auto& [place, term] : found) {
        if (!lines.empty()) lines += '\n';
        lines.append(term->id).append(": ").append(term->text);
    }
    return lines;
}

std::string with_explanations(std::string_view text, std::string_view shown) {
    const std::string terms = explanations(shown);
    const bool both = !text.empty() && !terms.empty();
    return std::string(text) + (both ? "\n\n" : "") + terms;
}

}  // namespace steplab
