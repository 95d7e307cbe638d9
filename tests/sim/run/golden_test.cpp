#include "support/runs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

namespace steplab::test {
namespace {

/// "model method precision" -> hash after 300 steps, for the whole catalogue in small variations.
std::map<std::string, std::string> computed_hashes(const Execution& execution) {
    std::map<std::string, std::string> hashes;
    const auto add = [&](const std::string& name, const RunDescription& description) {
        Simulation simulation(description, execution);
        simulation.advance(300);
        hashes[name] = simulation.hash();
    };
    for (const MethodCase& c : all_methods()) {
        for (const Model* const model : models_for(c.id(), c.precision)) {
            const auto name = fmt::format("{} {} {}", model->info.id, c.info->id, id(c.precision));
            add(name, small_run_of(model->info.id, c.info->id, c.precision, model->info.id == "rope" ? 0.01 : 0.1));
        }
    }
    for (const Precision precision : precisions) {
        add(fmt::format("chain-c0.3-n37 rk4 {}", id(precision)),
            run_of("chain", "rk4", precision, 0.1, {{"c", 0.3}, {"n", 37}}));
        add(fmt::format("chain-c0.3-n37 verlet {}", id(precision)),
            run_of("chain", "verlet", precision, 0.1, {{"c", 0.3}, {"n", 37}}));
        add(fmt::format("morse-cutoff1 verlet {}", id(precision)),
            run_of("morse", "verlet", precision, 0.01, {{"cutoff", 1}, {"edge", 4}}));
    }
    return hashes;
}

std::map<std::string, std::string> golden_hashes() {
    std::map<std::string, std::string> hashes;
    std::ifstream file(STEPLAB_SOURCE_DIR "/assets/golden/hashes.txt");
    std::string model, method, precision, hash;
    while (file >> model >> method >> precision >> hash) hashes[model + " " + method + " " + precision] = hash;
    return hashes;
}

// The same bits from every compiler, level of optimisation and instruction set: the continuous checks run this test
// with g++ and clang++, scripts/sanitize.sh hardly optimised.
class GoldenHashes : public testing::TestWithParam<Instructions> {};

TEST_P(GoldenHashes, are_those_of_every_compiler) {
    const auto computed = computed_hashes({.instructions = GetParam()}), golden = golden_hashes();
    EXPECT_EQ(computed.size(), golden.size());
    bool all_equal = true;
    for (const auto& [run, hash] : computed) {
        const auto known = golden.find(run);
        EXPECT_EQ(hash, known == golden.end() ? "unknown" : known->second) << run;
        all_equal = all_equal && known != golden.end() && known->second == hash;
    }
    if (!all_equal) {
        const std::string path = STEPLAB_BINARY_DIR "/hashes.txt";
        std::ofstream file(path);
        for (const auto& [run, hash] : computed) file << run << " " << hash << "\n";
        ADD_FAILURE() << "what was computed is in " << path << "; if the change is meant, copy it to assets/golden/";
    }
}

INSTANTIATE_TEST_SUITE_P(With, GoldenHashes, testing::ValuesIn(instructions_here().begin(), instructions_here().end()),
                         [](const auto& instance) { return std::string(id(instance.param)); });

// But in free fall, where several methods are exact, and where there is no drag, without which velocity-verlet takes
// the very steps of verlet.
TEST(Hashes, tell_every_run_from_every_other) {
    std::map<std::string, std::string> runs;
    const std::map<std::string, std::string> golden = golden_hashes();
    std::size_t compared = 0;
    for (const auto& [run, hash] : golden) {
        if (run.starts_with("free ")) continue;
        ++compared;
        std::string twin = run;
        if (const std::size_t at = run.find(" velocity-verlet "); at != std::string::npos) twin.erase(at + 1, 9);
        if (twin != run && !run.starts_with("rope ")) {
            EXPECT_EQ(hash, golden.at(twin)) << run;
        } else {
            EXPECT_TRUE(runs.emplace(hash, run).second) << run << " has the hash of " << runs[hash];
        }
    }
    EXPECT_GT(compared, methods().size());
}

}  // namespace
}  // namespace steplab::test
