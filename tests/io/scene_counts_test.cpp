// How many particles an expression makes, and which parameters are whole numbers.
#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// A line of `count` particles, a text as the file has it.
std::string counted(const std::string& parameters, const std::string& count) {
    return "steplab = 1\n[parameters]\n" + parameters + "\n[[particles]]\ngroup = \"row\"\nline = { count = " + count +
           ", step = [1, 0, 0] }\n";
}

double particles_in(Precision precision, const std::string& text) {
    RunDescription run = describe(read_scene(text));
    run.precision = precision;
    const RunDescription held = as_held(run);
    return model_of(held).particles(held.scene);
}

// 1/d + 1 in decimals is whole; in float, or by the order of roundings, it is so nearly.
TEST(SceneCounts, are_whole_in_float_and_double_where_they_are_in_decimals) {
    for (const double length : {0.3, 1.0, 7.0, 49.0}) {
        for (const int parts : {1, 3, 7, 10, 49, 100, 997, 10000, 99999}) {
            const std::string text = counted(fmt::format("l = {}\nd = {}", length, length / parts), "\"l / d + 1\"");
            for (const Precision precision : {Precision::float_, Precision::double_})
                EXPECT_EQ(particles_in(precision, text), parts + 1) << length << ' ' << id(precision);
        }
    }
    EXPECT_EQ(particles_in(Precision::float_, counted("d = 0.1", "\"1/d + 1\"")), 11);
}

TEST(SceneCounts, that_are_not_whole_are_refused_however_large) {
    for (const char* count : {"7.5", "7.00001", "100.01", "99999.5", "1234567.5", "4000000000.5", "0.4", "-3"}) {
        EXPECT_THAT(refusal_of_scene(counted(fmt::format("x = {}", count), "\"x + 0\"")),
                    HasSubstr("a.toml:6:18: must be an integer from 1"))
            << count;
        EXPECT_THAT(refusal_of_scene(counted("", count)), HasSubstr("must be an integer from 1")) << count;
    }
    EXPECT_THAT(refusal_of_scene(counted("", "7.0000001")), HasSubstr("must be an integer")) << "written as it is";
    EXPECT_THAT(refusal_of_scene(counted("n = 7.0000001", "\"n\"")), HasSubstr("must be an integer"));
}

const ParameterInfo& parameter_of(const RunDescription& run, std::string_view name) {
    for (const ParameterInfo& info : run.scene.infos()) {
        if (info.name == name) return info;
    }
    throw UsageError("no such parameter");
}

/// A scene in which n is a count of this key.
std::string with_count(const std::string& value, const std::string& key) {
    return "steplab = 1\n[parameters]\nx = 2\nn = " + value +
           "\nalias = \"n\"\n[[particles]]\nposition = [\"x*alias\", "
           "0, 0]\nmass = \"n\"\n[[particles]]\n" +
           key + "\n[[fields]]\ngravity = [\"x\", 0, 0]\n";
}

TEST(SceneCounts, that_are_a_parameter_make_it_a_whole_number) {
    for (const char* key :
         {"line = { count = \"n\", step = [1, 0, 0] }", "line = { count = \"alias\", step = [1, 0, 0] }",
          "grid = { count = [2, \" n \"], steps = [[1, 0, 0], [0, 1, 0]] }",
          "grid = { count = [\"(n)\", 2], steps = [[1, 0, 0], [0, 1, 0]] }", "lattice = { cells = [1, 1, \"n\"] }"}) {
        SCOPED_TRACE(key);
        RunDescription run = describe(read_scene(with_count("{ value = 3, range = [2, 40] }", key)));
        const ParameterInfo& info = parameter_of(run, "n");
        EXPECT_EQ(info.kind, ParameterInfo::Kind::integer);
        EXPECT_EQ(std::pair(info.slider_low, info.slider_high), std::pair(2.0, 40.0));
        EXPECT_EQ(parameter_of(run, "x").kind, ParameterInfo::Kind::real);
        for (const char* wrong : {"7.7", "0", "-2", "1e12", "nan"}) {
            try {
                set_parameter(run, "n", wrong);
                ADD_FAILURE() << wrong;
            } catch (const UsageError& error) {
                EXPECT_THAT(error.what(), HasSubstr("n must be an integer")) << wrong;
            }
        }
        set_parameter(run, "n", "5");
        EXPECT_GE(model_of(run).particles(run.scene), 6);
        const RunDescription plain = describe(read_scene(with_count("3", key)));
        EXPECT_EQ(parameter_of(plain, "n").slider_low, 1);
        EXPECT_EQ(parameter_of(plain, "n").slider_high, 6);
    }
}

TEST(SceneCounts, within_an_expression_leave_their_parameters_real) {
    for (const char* count : {"\"2 * n\"", "\"n + 1\"", "\"-(-n)\"", "\"max(n, 2)\""}) {
        const RunDescription run = describe(read_scene(counted("n = 3", count)));
        EXPECT_EQ(parameter_of(run, "n").kind, ParameterInfo::Kind::real) << count;
    }
}

}  // namespace
}  // namespace steplab::test
