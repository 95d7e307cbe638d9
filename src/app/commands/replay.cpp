#include "app/commands/replay.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/standard_streams.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/commit.hpp"
#include "io/json_text.hpp"
#include "io/output_file.hpp"
#include "session/lesson_check.hpp"
#include "session/replay.hpp"
#include "session/session_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

constexpr const char* replay_examples =
    "Examples:\n"
    "  steplab view --model rope --session rope.session    (record)\n"
    "  steplab replay rope.session\n"
    "  steplab replay --lesson order\n\n";

std::string counted(std::uint64_t count, std::string_view of) {
    return fmt::format("{} {}{}", count, of, count == 1 ? "" : "s");
}

/// Runs a replay to its end or to the first difference, which is returned.
std::optional<std::string> run_to_end(Replay& replay) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds between_looks(50);
    Progress progress(std::max<std::uint64_t>(1, replay.all_steps()), isatty(STDERR_FILENO) != 0, "steplab replay");
    std::uint64_t piece = 1;
    while (!replay.is_done()) {
        check_interruption();
        if (replay.is_due()) {
            if (auto difference = replay.perform()) return difference;
            continue;
        }
        const auto begin = Clock::now();
        replay.approach(piece);
        piece = Clock::now() - begin < between_looks ? piece * 2 : std::max<std::uint64_t>(1, piece / 2);
        progress.at(std::min(replay.steps(), replay.all_steps()));
    }
    return std::nullopt;
}

class ReplayCommand final : public Command {
public:
    std::string_view name() const override { return "replay"; }
    std::string_view what() const override { return "Compute a recorded session again and compare the hashes"; }

    void declare(CLI::App& app) override {
        text_option(app, "file", file_, "FILE", "Session file, as the window writes it");
        text_option(app, "--lesson", lesson_, "NAME|FILE",
                    "In place of FILE: the session of a lesson; prints what its facts are measured to be");
        text_option(app, "--summary", summary_, "FILE|-", "Summary of the replay (JSON)");
        footer(app, [] { return std::string(replay_examples); });
    }

    int run() override {
        if (!lesson_.empty()) return check_lesson();
        if (file_.empty()) throw UsageError("FILE is required: the session file to replay");
        catch_interruptions();
        Recording recording = read_session_file(file_);
        Session session(recording.start);
        Replay replay(std::move(recording), session);
        const std::optional<std::string> difference = run_to_end(replay);
        if (!summary_.empty()) write_summary(replay, session, difference);
        if (difference) throw Error(ExitCode::replay, fmt::format("{}: {}", shown(file_), *difference));
        print_result(replay);
        return static_cast<int>(ExitCode::done);
    }

private:
    /// What a lesson states beside what its session computes.
    int check_lesson() const {
        if (!file_.empty() || !summary_.empty())
            throw UsageError("--lesson names a lesson in place of FILE; it has no summary");
        catch_interruptions();
        const Lesson lesson = find_lesson(lesson_);
        const std::vector<CheckedFact> facts = check_facts(lesson);
        std::size_t wrong = 0;
        for (const CheckedFact& each : facts) {
            if (!each.holds()) ++wrong;
            print(text_of(each));
        }
        if (wrong > 0)
            throw Error(ExitCode::replay, fmt::format("{}: {} not as stated", shown(lesson_), counted(wrong, "fact")));
        return static_cast<int>(ExitCode::done);
    }

    /// "page 2  ok     position error of run 1 over run 0: 15.9 (stated: 15 to 17, "16 times")"
    static std::string text_of(const CheckedFact& each) {
        const LessonFact& fact = each.fact;
        return fmt::format("page {}  {:<5}  {} of run {}{}{}: {} (stated: {} to {}, \"{}\")\n", each.page + 1,
                           each.holds() ? "ok" : "WRONG", fact.quantity, fact.run,
                           fact.over ? fmt::format(" over run {}", *fact.over) : "",
                           fact.step ? fmt::format(" at step {}", *fact.step) : "", significant(each.value, 5),
                           exact_text(fact.least), exact_text(fact.most), shown(fact.says));
    }

    void print_result(const Replay& replay) const {
        print_beside(fmt::format("{}, {}: {}\n", counted(replay.handled(), "event"), counted(replay.steps(), "step"),
                                 replay.compared() ? "the same hashes" : "the file has no hash to compare with"),
                     summary_ == "-");
    }

    void write_summary(const Replay& replay, const Session& session,
                       const std::optional<std::string>& difference) const {
        const Simulation& run = session.run();
        nlohmann::ordered_json json{{"file", shown(file_)},
                                    {"events", replay.handled()},
                                    {"steps", replay.steps()},
                                    {"runs", 1 + session.followers().size()},
                                    {"status", difference ? "differs" : "ok"},
                                    {"step", run.step()},
                                    {"hash", run.hash()},
                                    {"version", STEPLAB_VERSION}};
        if (difference) json["reason"] = *difference;
        OutputFile file(summary_);
        file.write(json_text(json));
        file.commit();
    }

    std::string file_;
    std::string lesson_;
    std::string summary_;
};

}  // namespace

std::unique_ptr<Command> replay_command() { return std::make_unique<ReplayCommand>(); }

}  // namespace steplab
