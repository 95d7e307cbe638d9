#include "app/program.hpp"
#include "io/files.hpp"
#include "io/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace steplab::test {
namespace {

// 250 000 positions alone would be 6 MB.
TEST(Export, takes_no_memory_for_each_particle) {
    const TemporaryFolder folder;
    const auto kilobytes_of = [&](const std::string& size) {
        const Outcome outcome = run_program({"export", "--model", "mesh", "--set", "dim=" + size, "--steps", "1",
                                             "--to", "lammps", "--out", folder.file(size)});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.kilobytes;
    };
    EXPECT_LT(kilobytes_of("500"), kilobytes_of("20") + 4000);
}

// In LAMMPS they begin a text of several lines, also in a comment.
TEST(Export, of_a_title_with_quotes_is_read_by_lammps) {
    const TemporaryFolder folder;
    put_text(folder.file("quotes.toml"),
             "steplab = 1\ntitle = \"a \\\"\\\"\\\" b\"\n[[particles]]\n[[particles]]\nposition = [1, 0, 0]\n"
             "[[pairs]]\npotential = \"(r - 1)^2\"\ncutoff = 3\n[run]\nmethod = \"velocity-verlet\"\n");
    const Outcome outcome =
        run_program({"cluster", "--scene", folder.file("quotes.toml"), "--steps", "2", "--ranks", "1"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

}  // namespace
}  // namespace steplab::test
