#include "app/program.hpp"
#include "core/instructions.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A wrong command line, and the words that its message must contain.
struct WrongUse {
    std::vector<std::string> arguments;
    std::vector<std::string> named;
    int code = 2;
};

void PrintTo(const WrongUse& use, std::ostream* out) {
    for (const std::string& argument : use.arguments) *out << '\'' << argument << "' ";
}

const std::vector<WrongUse> wrong_uses{
    // unknown words: the nearest and the known ones
    {{"rnu"}, {"unknown command 'rnu'", "run", "list", "view"}},
    {{"run", "--model", "chains"}, {"unknown model 'chains'", "did you mean 'chain'", "free", "rope", "morse"}},
    {{"run", "--method", "rk5"}, {"unknown method 'rk5'", "did you mean 'rk4'", "euler", "verlet"}},
    {{"run", "--precision", "half"}, {"unknown precision 'half'", "float", "double"}},
    {{"run", "--threads", "0"}, {"--threads", "0", "an integer from 1"}},
    {{"run", "--threads", "two"}, {"--threads", "two"}},
    {{"run", "--isa", "sse9"}, {"unknown instruction set 'sse9'", std::string(id(fastest_instructions()))}},
    {{"run", "--stpes", "5"}, {"unknown option '--stpes'", "did you mean '--steps'", "--until"}},
    {{"run", "--stpes=5"}, {"unknown option '--stpes'"}},
    {{"run", "-q"}, {"unknown option '-q'", "--model"}},
    {{"--modle", "rope"}, {"unknown option '--modle'", "did you mean '--model'"}},
    {{"list", "method"}, {"unknown list 'method'", "methods"}},
    {{"list", "--jsn"}, {"unknown option '--jsn'", "--json"}},
    {{"run", "--out", "-", "--format", "xzy"}, {"unknown format 'xzy'", "csv", "xyz"}},
    {{"run", "--set", "n=3"}, {"'n'", "mesh", "dim"}},
    {{"run", "--set", "substeps=3"}, {"'substeps'", "rk4"}},
    // ensembles
    {{"run", "--spread", "k=1:2"}, {"--spread", "--ensemble"}},
    {{"run", "--ensemble", "0"}, {"--ensemble", "an integer from 1"}},
    {{"run", "--ensemble", "2.5"}, {"--ensemble", "2.5"}},
    {{"run", "--ensemble", "2", "--spread", "k"}, {"'k'", "name=a:b"}},
    {{"run", "--ensemble", "2", "--spread", "k=1"}, {"'k=1'", "name=a:b"}},
    {{"run", "--ensemble", "2", "--spread", "k=1:two"}, {"k", "two"}},
    {{"run", "--ensemble", "2", "--spread", "k=0:1"}, {"k", "> 0"}},
    {{"run", "--ensemble", "2", "--spread", "dt=0:1"}, {"dt", "> 0"}},
    {{"run", "--ensemble", "2", "--spread", "kk=1:2"}, {"unknown parameter 'kk'", "dt", "compensated"}},
    {{"run", "--ensemble", "2", "--spread", "kick=centre:corner"}, {"kick", "only numbers"}},
    {{"run", "--ensemble", "3", "--spread", "dim=5:6"}, {"run 1", "dim", "5.5"}},
    {{"run", "--ensemble", "2", "--spread", "k=1:2", "--spread", "k=1:3"}, {"'k'", "more than once"}},
    {{"run", "--ensemble", "2", "--out", "a.xyz"}, {"--out", "CSV"}},
    {{"run", "--ensemble", "2", "--out", "a.csv", "--every", "0"}, {"--every"}},
    // the shape of the command line
    {{"run", "10"}, {"unexpected argument '10'"}},
    {{"run", "--steps"}, {"--steps needs a value"}},
    {{"run", "--steps="}, {"--steps needs a value"}},
    {{"run", "--steps", ""}, {"--steps needs a value"}},
    {{"run", "--model", ""}, {"--model needs a value"}},
    {{"run", "--out", ""}, {"--out needs a value"}},
    {{"run", "--dt", "0.1", "--dt", "0.2"}, {"--dt is given more than once"}},
    {{"run", "--steps", "1", "--until", "1"}, {"--steps", "--until"}},
    {{"run", "--set", "dim"}, {"'dim'", "name=value"}},
    {{"run", "--set", "=5"}, {"'=5'", "name=value"}},
    {{"run", "--set", "dim="}, {"dim", "an integer >= 3"}},
    {{"run", "--set", "{}"}, {"'{}'", "name=value"}},
    {{"run", "--set", "dim=5", "--set", "dim=6"}, {"'dim'", "more than once"}},
    // numbers: the range
    {{"run", "--model", "free", "--set", "n=0"}, {"n", "an integer >= 1"}},
    {{"run", "--model", "chain", "--set", "n=1"}, {"n", "an integer >= 2"}},
    {{"run", "--set", "dim=2.5"}, {"dim", "2.5", "an integer >= 3"}},
    {{"run", "--set", "m=-1"}, {"m", "-1", "a number > 0"}},
    {{"run", "--set", "m=0"}, {"m", "a number > 0"}},
    {{"run", "--set", "m=nan"}, {"m", "nan", "a number > 0"}},
    {{"run", "--set", "k=inf"}, {"k", "inf", "a number > 0"}},
    {{"run", "--set", "v0=-inf"}, {"v0", "-inf", "a finite number"}},
    {{"run", "--set", "k=1e309"}, {"k", "1e309"}},
    {{"run", "--set", "k=1.0x"}, {"k", "\"1.0x\""}},
    {{"run", "--set", "k=0x10"}, {"k", "\"0x10\""}},
    {{"run", "--set", "k=1,5"}, {"k", "\"1,5\""}},
    {{"run", "--set", "k= 1"}, {"k", "\" 1\""}},
    {{"run", "--set", "kick=center"}, {"kick", "\"center\"", "centre or corner"}},
    {{"run", "--set", "m=1e308", "--precision", "float"}, {"m", "float"}},
    {{"run", "--dt", "0"}, {"--dt", "a number > 0"}},
    {{"limits", "--dt", "-0.1"}, {"--dt", "-0.1", "a number > 0"}},
    {{"run", "--method", "dopri5", "--dt", "-0.1"}, {"dopri5", "dt must be > 0", "reverse the velocities"}},
    {{"run", "--dt", "-0.1", "--until", "1"}, {"--until 1", "dt = -0.1", "differ in sign"}},
    {{"run", "--dt", "nan"}, {"--dt", "nan"}},
    {{"run", "--dt", "inf"}, {"--dt", "inf"}},
    {{"run", "--dt", "1e-60", "--precision", "float"}, {"dt", "1e-60", "float"}},
    {{"run", "--steps", "-1"}, {"--steps", "-1", "an integer from 0"}},
    {{"run", "--steps", "1.5"}, {"--steps", "1.5", "an integer"}},
    {{"run", "--steps", "99999999999999999999"}, {"--steps", "to 9007199254740992"}},
    {{"run", "--until", "-1"}, {"--until", "-1"}},
    {{"run", "--until", "nan"}, {"--until", "nan"}},
    {{"run", "--until", "1e308"}, {"--until", "1e308", "9007199254740992"}},
    {{"run", "--every", "0"}, {"--every", "an integer from 1"}},
    {{"run", "--every", "-3"}, {"--every", "-3"}},
    {{"run", "--every", "2x"}, {"--every", "\"2x\""}},
    // more than fits into memory: refused before anything is allocated, with the memory it needs
    {{"run", "--model", "free", "--set", "n=1e12"}, {"1e12 particles", "B of memory", "smaller n"}},
    {{"run", "--model", "mesh", "--set", "dim=1000000"}, {"1e12 particles", "B of memory", "smaller dim"}},
    {{"run", "--model", "morse", "--set", "edge=100000"}, {"particles", "B of memory", "smaller edge"}},
    {{"run", "--model", "rope", "--set", "n=1e300"}, {"n", "1e300"}},
    // particles
    {{"run", "--out", "-", "--particles", "100"}, {"no particle 100", "0 to 99"}},
    {{"run", "--out", "-", "--particles", "0-100"}, {"no particle 100", "0 to 99"}},
    {{"run", "--out", "-", "--particles", "99999999999999999999"}, {"no particle 99999999999999999999"}},
    {{"run", "--out", "-", "--particles", "3-1"}, {"3-1", "backwards"}},
    {{"run", "--out", "-", "--particles", "-1"}, {"'-1'", "9,0-3"}},
    {{"run", "--out", "-", "--particles", "1,,2"}, {"'1,,2'", "9,0-3"}},
    {{"run", "--out", "-", "--particles", "one"}, {"'one'", "9,0-3"}},
    {{"run", "--particles", "1"}, {"--particles", "no --out"}},
    {{"run", "--format", "csv"}, {"--format", "no --out"}},
    // outputs that overwrite each other, or have no known format
    {{"run", "--out", "-", "--summary", "-"}, {"--out", "--summary", "standard output"}},
    {{"run", "--out", "a.csv", "--series", "./a.csv"}, {"--out", "--series", "a.csv"}},
    {{"run", "--series", "a.csv", "--summary", "a.csv"}, {"--series", "--summary", "a.csv"}},
    {{"run", "--out", "a.txt"}, {"'a.txt'", ".csv", ".xyz", "--format"}},
    {{"run", "--out", "a"}, {"'a'", ".csv", ".xyz", "--format"}},
    // files
    {{"run", "--out", "missing/a.csv"}, {"'missing/a.csv'", "no folder"}, 3},
    {{"run", "--series", "missing/a.csv"}, {"'missing/a.csv'", "no folder"}, 3},
    {{"run", "--summary", "missing/a.json"}, {"'missing/a.json'", "no folder"}, 3},
    {{"run", "--out", "."}, {"'.'", "folder"}, 3},
    {{"run", "--out", "/dev/full"}, {"/dev/full", "No space left on device"}, 3},
    {{"run", "--series", "/dev/full"}, {"/dev/full", "No space left on device"}, 3},
    {{"run", "--summary", "/dev/full"}, {"/dev/full", "No space left on device"}, 3},
    // the lab
    {{"report"}, {"--out DIR is required"}},
    {{"report", "--out", "o", "--model", "chian"}, {"unknown model 'chian'", "did you mean 'chain'"}},
    {{"report", "--out", "o", "--method", "rk5"}, {"unknown method 'rk5'"}},
    {{"report", "--out", "o", "--precision", "half"}, {"unknown precision 'half'"}},
    {{"report", "--out", "o", "--error", "0"}, {"--error", "a number > 0"}},
    {{"report", "--out", "o", "--error", "small"}, {"--error", "\"small\""}},
    {{"report", "--out", "o", "--time", "0"}, {"--time", "a number > 0"}},
    {{"report", "--out", "o", "--time", "nan"}, {"--time", "nan"}},
    {{"report", "--out", "o", "--set", "q=1"}, {"'q'"}},
    {{"report", "--out", "o", "--model", "chain", "--set", "dim=5"}, {"'dim'"}},
    {{"report", "--out", "o", "--thesis", "--quick"}, {"--thesis", "--quick"}},
    {{"report", "--out", "o", "--thesis", "--model", "chain"}, {"--thesis", "--model"}},
    {{"report", "--out", "/dev/null/o", "--quick"}, {"/dev/null/o"}, 3},
    {{"report", "--out", "/dev/null/o", "--thesis"}, {"/dev/null/o"}, 3},
    {{"advise"}, {"--error E is required"}},
    {{"advise", "--model", "chain", "--until", "1", "--error", "1e-30"}, {"1e-30", "exact solution"}},
    {{"advise", "--model", "chain", "--until", "0", "--error", "1e-3"}, {"must be > 0"}},
    {{"advise", "--error", "-1"}, {"--error", "-1"}},
    {{"hard-cases", "stiff-rop"}, {"unknown hard case 'stiff-rop'", "did you mean 'stiff-rope'", "chaos"}},
    {{"hard-cases", "chaos", "deep"}, {"unexpected argument 'deep'"}},
    {{"help", "runn"}, {"unknown command 'runn'", "did you mean 'run'"}},
    {{"help", "run", "list"}, {"help", "one command"}},
    {{"convert"}, {"FILE is required"}},
    {{"snapshot"}, {"--out FILE.png is required"}},
    {{"snapshot", "--out", "a.gif"}, {"--out", ".png", "a.gif"}},
    {{"snapshot", "--out", "a.png", "--size", "0x5"}, {"--size", "WIDTHxHEIGHT", "0x5"}},
    {{"snapshot", "--out", "a.png", "--colour", "column:q"},
     {"column:q", "no column besides positions and velocities"}},
    {{"record"}, {"--out FILE is required", "frames/%05d.png"}},
    {{"record", "--out", "a.avi"}, {"--out", ".mp4", ".webm", ".gif", "a.avi"}},
    {{"record", "--out", "a.png"}, {"one number", "frames/%05d.png", "a.png"}},
    {{"record", "--out", "a.mp4", "--fps", "0"}, {"--fps", "from 1 to 1000"}},
    {{"record", "--out", "a.mp4", "--size", "5x4"}, {"--size 5x4", "even"}},
    {{"limits", "--model", "chain", "--method", "al"}, {"unknown method 'al'"}},
    {{"limits", "--model", "chain", "--steps", "5"}, {"unknown option '--steps'"}},
};

class WrongUses : public testing::TestWithParam<WrongUse> {};

TEST_P(WrongUses, end_with_one_clear_line_and_nothing_written) {
    const WrongUse& use = GetParam();
    const TemporaryFolder folder;
    const Outcome outcome = run_program(use.arguments, {.folder = folder.path()});
    EXPECT_EQ(outcome.code, use.code);
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("steplab"));
    for (const std::string& word : use.named) EXPECT_THAT(outcome.err, HasSubstr(word));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(folder.empty());
}

INSTANTIATE_TEST_SUITE_P(CommandLine, WrongUses, testing::ValuesIn(wrong_uses));

TEST(WrongUse, neighbours_of_the_refused_are_accepted) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"run", "--model", "free", "--set", "n=1"},
             {"run", "--model", "chain", "--set", "n=2", "--steps", "0"},
             {"run", "--set", "dim=3", "--steps", "1e2"},
             {"run", "--set", "v0=-1", "--steps=5"},
             {"run", "--until", "0"},
             {"run", "--out", "-", "--particles", "99,0-3,2"},
             {"run", "--out", "a.csv", "--series", "b.csv", "--summary", "-"},
             {"run", "--out", "a.txt", "--format", "xyz"},
             {"run", "--out", "/dev/null", "--series", "/dev/null"},
             {"run", "--ensemble", "1", "--spread", "k=1:2", "--steps", "1"},
             {"run", "--ensemble", "3", "--spread", "dim=5:7", "--steps", "1"},
             {"run", "--ensemble", "2", "--steps", "0"},
         }) {
        const Outcome outcome = run_program(arguments, {.folder = folder.path()});
        EXPECT_EQ(outcome.code, 0) << testing::PrintToString(arguments) << outcome.err;
    }
}

TEST(WrongUse, values_at_the_end_of_the_numbers_never_crash) {
    for (const std::string setting : {"m=1e308", "m=1e-308", "k=1e308", "L=1e308", "v0=1e308", "v0=-1e308", "v0=0"}) {
        for (const std::string model : {"chain", "mesh"}) {
            const Outcome outcome = run_program({"run", "--model", model, "--set", setting, "--summary", "-"});
            EXPECT_EQ(outcome.signal, 0) << model << ' ' << setting;
            EXPECT_TRUE(outcome.code == 0 || outcome.code == 4) << model << ' ' << setting << ' ' << outcome.err;
        }
    }
    for (const std::string dt : {"1e308", "1e-308", "5e-324"}) {
        EXPECT_EQ(run_program({"run", "--dt", dt}).signal, 0) << dt;
    }
}

/// Every place of the command line that repeats an argument in its message.
const std::vector<std::vector<std::string>> places{{"run", "--model"},
                                                   {"run", "--method"},
                                                   {"run", "--precision"},
                                                   {"run", "--set"},
                                                   {"run", "--dt"},
                                                   {"run", "--steps"},
                                                   {"run", "--until"},
                                                   {"run", "--every"},
                                                   {"run", "--isa"},
                                                   {"run", "--spread"},
                                                   {"run", "--out"},
                                                   {"run", "--out", "-", "--format"},

                                                   {"run", "--out", "-", "--particles"},
                                                   {"run", "--out", "-", "--columns"},
                                                   {"convert"},
                                                   {"convert", "missing", "--out"},
                                                   {"snapshot", "--out"},
                                                   {"record", "--out"},
                                                   {"list"},
                                                   {"help"},
                                                   {"run"},
                                                   {"report", "--out", "/dev/null/o", "--set"},
                                                   {"hard-cases"},
                                                   {}};

TEST(WrongUse, arguments_reach_the_terminal_shortened_and_without_control_characters) {
    const TemporaryFolder folder;
    for (std::vector<std::string> arguments : places) {
        for (const std::string& argument : {std::string(5000, 'x'),
                                            std::string("a/\x1b[2J\a\n\x7f"
                                                        "b=\x1b"),
                                            "--" + std::string(5000, 'x'), std::string("--\x1b[2J")}) {
            std::vector<std::string> words = arguments;
            words.push_back(argument);
            const Outcome outcome = run_program(words, {.folder = folder.path()});
            EXPECT_NE(outcome.code, 0) << testing::PrintToString(words);
            EXPECT_EQ(outcome.signal, 0);
            EXPECT_LT(outcome.err.size(), 2500u) << testing::PrintToString(words);
            EXPECT_EQ(std::count_if(outcome.err.begin(), outcome.err.end(),
                                    [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7f; }),
                      0)
                << outcome.err;
            EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        }
    }
    EXPECT_TRUE(folder.empty());
}

}  // namespace
}  // namespace steplab
