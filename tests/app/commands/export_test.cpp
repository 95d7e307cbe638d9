#include "app/program.hpp"
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

}  // namespace
}  // namespace steplab::test
