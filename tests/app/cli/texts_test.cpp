#include "app/cli/particle_list.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/text_table.hpp"
#include "core/error.hpp"

#include <gmock/gmock.h>

namespace steplab {
namespace {

using testing::ElementsAre;

TEST(ParticleList, is_ascending_with_each_particle_once) {
    EXPECT_THAT(parse_particles("--particles", "9,0-3", 10), ElementsAre(0, 1, 2, 3, 9));
    EXPECT_THAT(parse_particles("--particles", "2,2,1-2", 10), ElementsAre(1, 2));
    EXPECT_THAT(parse_particles("--particles", "0", 1), ElementsAre(0));
}

TEST(ParticleList, refuses_everything_else) {
    for (const char* text : {"", ",", "1,", ",1", "-", "1-", "-1", "1-2-3", "a", "1.0", "+1", " 1", "10", "0-10", "3-2",
                             "18446744073709551616", "0-18446744073709551615"}) {
        EXPECT_THROW(parse_particles("--particles", text, 10), UsageError) << text;
    }
}

TEST(Progress, shows_the_part_done_and_the_time_left) {
    EXPECT_EQ(progress_text(0.5, 10), "[###############---------------]  50 %  10 s left");
    EXPECT_EQ(progress_text(0.999, 900), "[#############################-]  99 %  1 s left");
    EXPECT_EQ(progress_text(0.1, 60), "[###---------------------------]  10 %  9 min 00 s left");
    EXPECT_EQ(progress_text(0.01, 100), "[------------------------------]   1 %  2 h 45 min left");
    EXPECT_EQ(progress_text(1, 5), "[##############################] 100 %  0 s left");
}

TEST(TextTable, heads_take_as_many_lines_as_make_the_table_fit) {
    EXPECT_EQ(aligned({"method", "energy error"}, {{"rk4", "1"}, {"euler", "2"}}, 0),
              "method  energy error\nrk4     1\neuler   2\n");
    const Row head{"method", std::string(50, 'a') + " b", std::string(40, 'c') + " d"};
    const std::string table = aligned(head, {{"rk4", "1", "2"}}, 0);
    EXPECT_EQ(table, "method  " + std::string(50, 'a') + "  " + std::string(40, 'c') + "\n        b" +
                         std::string(51, ' ') + "d\nrk4     1" + std::string(51, ' ') + "2\n");
}

TEST(TextTable, last_column_is_wrapped) {
    const std::string words = std::string(60, 'a') + ' ' + std::string(30, 'b') + ' ' + std::string(30, 'c');
    EXPECT_EQ(aligned({{"x", words}}, 2),
              "  x  " + std::string(60, 'a') + ' ' + std::string(30, 'b') + "\n     " + std::string(30, 'c') + '\n');
}

}  // namespace
}  // namespace steplab
