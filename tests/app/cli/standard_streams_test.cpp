#include "app/cli/standard_streams.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <utility>

namespace steplab {
namespace {

struct Streams {
    std::string out, err;
    friend bool operator==(const Streams&, const Streams&) = default;
};

void PrintTo(const Streams& streams, std::ostream* out) { *out << '(' << streams.out << '|' << streams.err << ')'; }

Streams written_by(const std::function<void()>& work) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    work();
    std::string out = testing::internal::GetCapturedStdout();
    return {std::move(out), testing::internal::GetCapturedStderr()};
}

TEST(StandardStreams, text_for_people_is_safe_on_both) {
    EXPECT_EQ(written_by([] { print("a \x1b[2J\tb\n"); }), (Streams{"a \\x1b[2J\tb\n", ""}));
    EXPECT_EQ(written_by([] { print_aside("a \x1b[2J\n"); }), (Streams{"", "a \\x1b[2J\n"}));
    EXPECT_EQ(written_by([] { print_note("steplab run", "a \x9b"); }), (Streams{"", "steplab run: note: a \\x9b\n"}));
}

TEST(StandardStreams, text_stands_beside_data) {
    EXPECT_EQ(written_by([] { print_beside("a\x1b", true); }), (Streams{"", "a\\x1b"}));
    EXPECT_EQ(written_by([] { print_beside("a\x1b", false); }), (Streams{"a\\x1b", ""}));
}

TEST(StandardStreams, data_is_as_it_is) {
    EXPECT_EQ(written_by([] { print_data("{\"a\x7f\"}\n"); }), (Streams{"{\"a\x7f\"}\n", ""}));
}

}  // namespace
}  // namespace steplab
