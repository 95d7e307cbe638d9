#pragma once

#include "session/recording.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// A number that a lesson states of its runs, so that it can be checked (LessonCheck).
struct LessonFact {
    std::string says;                        ///< the words of the page for which it stands
    std::string quantity;                    ///< one of lesson_quantities
    std::size_t run = 0;                     ///< of the session, the leading one being 0
    std::optional<std::size_t> over = {};    ///< divided by the same quantity of this run
    std::optional<std::uint64_t> step = {};  ///< of the leading run; none: at the end of the page's part
    double least = 0, most = 0;              ///< between which the number is
};

/// A page: what is to be done, what to watch and what it shows; and the part of the session that does it.
struct LessonPage {
    std::string title = {};
    std::string text = {};
    std::string act = {}, watch = {}, shows = {};  ///< empty where nothing is done
    std::size_t from = 0, to = 0;  ///< how many events of the session have happened before it and after it
    std::vector<std::string> plots = {};
    std::vector<std::string> terms = {};  ///< that it uses, explained behind them
    std::optional<double> speed = {};     ///< simulated seconds per second
    std::vector<LessonFact> facts = {};

    bool has_part() const { return to > from; }
};

/// A guided experiment: text in pages, and a recorded session of which each page does a part.
struct Lesson {
    std::string id;
    std::string title;
    std::string teaches;  ///< in one sentence
    std::uint64_t order = 0;
    std::vector<LessonPage> pages;
    std::shared_ptr<const Recording> session;
};

/// What a list of lessons says of one.
struct LessonTitle {
    std::string id, title, teaches;
    std::string scene;  ///< id of the model or scene that it begins with
    std::uint64_t order = 0;
};
LessonTitle title_of(const Lesson& lesson);

struct LessonQuantity {
    std::string_view id;
    std::string_view what;
};
/// What facts can be of. Lengths in m, times in s; energies relative to |E0|.
inline constexpr std::array lesson_quantities{
    LessonQuantity{"energy error", "E - E0 over |E0|, with its sign"},
    LessonQuantity{"largest energy error", "the largest |E - E0| over |E0| since the run began"},
    LessonQuantity{"position error", "largest distance of a particle from the exact solution or the reference, in m"},
    LessonQuantity{"phase error", "time by which the run is ahead of the motion, in s"},
    LessonQuantity{"momentum error", "|P - P0|, in kg m/s"},
    LessonQuantity{"distance", "largest distance of a particle from where the leading run has it, in m"},
    LessonQuantity{"distance from start", "largest distance of a particle from where the run began, in m"},
    LessonQuantity{"largest displacement", "the largest displacement of a particle since the run began, in m"},
    LessonQuantity{"stability limit", "largest stable dt of the method on the scene, in s"},
    LessonQuantity{"evaluations", "force evaluations since the run began"},
    LessonQuantity{"steps", "the step at which the run stands; of one that diverged, the last valid one"},
    LessonQuantity{"time", "where the run stands, in s"},
    LessonQuantity{"diverged", "1 if the run diverged, otherwise 0"}};

/// The plots that pages can show, by what the window calls them.
inline constexpr std::array<std::string_view, 10> lesson_plots{
    "energy error",   "energies", "position error", "displacement",    "velocity",
    "phase portrait", "momentum", "speeds",         "ensemble spread", "speed against error"};

/// The lesson of a file ID.toml, beside which lies its session, ID.session (docs/lessons.md). Throws FileError:
/// "FILE:LINE:COLUMN: what is wrong; what would be right".
Lesson read_lesson_file(const std::filesystem::path& path);

/// The same of the text of the former.
Lesson parse_lesson(const std::string& text, const std::string& name, Recording session);

/// The lesson of --lesson: a text with a slash, or that ends in .toml, is a file, any other the name of a shipped
/// lesson. Throws FileError, or UsageError that names the nearest one.
Lesson find_lesson(const std::string& name);

/// The lessons that come with the program, in the order in which they are best read. Throws FileError.
std::vector<Lesson> shipped_lessons();

}  // namespace steplab
