#include "core/stages.hpp"

#include "methods/gauss-16.hpp"
#include "models/forces/layouts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

/// A soft rope that falls from the level: everything moves, nothing is linear.
constexpr LineForces rope_of_stages{
    .count = 5, .first_fixed = true, .mass = 1, .k = 20, .rest_length = 0.5, .gravity = 9.81};

/// Every layout of forces at scattered positions, in this lanes type; and in plain numbers, stage by stage.
template <class N, class Forces>
std::pair<Field<N>, std::vector<Field<double>>> accelerations_at_stages(const Forces& forces, std::size_t particles) {
    Field<N> x(particles), a(particles);
    std::vector<Field<double>> plain;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        Field<double> positions(particles), accelerations(particles);
        each_coordinate(positions, [&](std::size_t k) {
            positions.flat()[k] = static_cast<double>((k * 37 + stage * 11) % 101) / 29 + static_cast<double>(k) / 7;
        });
        engine<double>(forces).accelerations(positions, accelerations);
        plain.push_back(accelerations);
    }
    each_coordinate(x, [&](std::size_t k) {
        alignas(64) double numbers[stage_count];
        for (std::size_t stage = 0; stage < stage_count; ++stage)
            numbers[stage] = static_cast<double>((k * 37 + stage * 11) % 101) / 29 + static_cast<double>(k) / 7;
        x.flat()[k] = N::load(numbers);
    });
    engine<double>(forces).template in<N>().accelerations(x, a);
    return {a, plain};
}

template <class Forces>
void expect_the_same_bits(const Forces& forces, std::size_t particles) {
    const auto in_registers = accelerations_at_stages<Stages<double>>(forces, particles);
    const auto& lanes = in_registers.first;
    const auto& plain = in_registers.second;
    const auto arrays = accelerations_at_stages<PlainLanes<double, stage_count>>(forces, particles).first;
    each_coordinate(lanes, [&](std::size_t k) {
        for (std::size_t stage = 0; stage < stage_count; ++stage) {
            EXPECT_EQ(lanes.flat()[k][stage], plain[stage].flat()[k]);
            EXPECT_EQ(arrays.flat()[k][stage], plain[stage].flat()[k]);
        }
    });
}

TEST(StageLanes, give_the_bits_of_plain_numbers_in_every_layout) {
    expect_the_same_bits(ConstantForces{.count = 6}, 6);
    expect_the_same_bits(rope_of_stages, 5);
    expect_the_same_bits(LineForces{.count = 19, .first_fixed = false, .mass = 2, .k = 3, .rest_length = 1}, 19);
    expect_the_same_bits(GridForces{.rows = 4, .columns = 4, .mass = 2, .k = 3, .rest_length = 1}, 16);
}

// Lanes that are plain arrays have no powers of two as fractions: they take another way to the exponential.
TEST(StageLanes, give_the_bits_of_plain_numbers_for_all_pairs) {
    const PairForces pairs{.count = 7};
    const auto [lanes, plain] = accelerations_at_stages<Stages<double>>(pairs, 7);
    const auto arrays = accelerations_at_stages<PlainLanes<double, stage_count>>(pairs, 7).first;
    each_coordinate(lanes, [&, &lanes = lanes, &plain = plain](std::size_t k) {
        for (std::size_t stage = 0; stage < stage_count; ++stage) {
            EXPECT_EQ(lanes.flat()[k][stage], plain[stage].flat()[k]);
            EXPECT_NEAR(arrays.flat()[k][stage], plain[stage].flat()[k], 1e-14);  // six numbers below 1
        }
    });
}

// In float and double near pairs are summed in the order of lists, at stages in that of indices.
TEST(StageLanes, give_near_pairs_but_for_the_order_of_sums) {
    NearPairForces near;
    near.count = 20;
    near.cutoff = 3;
    for (const double period : {0.0, 6.5}) {
        near.period = period;
        const auto [lanes, plain] = accelerations_at_stages<Stages<double>>(near, 20);
        const auto arrays = accelerations_at_stages<PlainLanes<double, stage_count>>(near, 20).first;
        each_coordinate(lanes, [&, &lanes = lanes, &plain = plain](std::size_t k) {
            for (std::size_t stage = 0; stage < stage_count; ++stage) {
                // sums of at most 19 numbers below 1
                EXPECT_NEAR(lanes.flat()[k][stage], plain[stage].flat()[k], 1e-14);
                EXPECT_NEAR(arrays.flat()[k][stage], lanes.flat()[k][stage], 1e-14);
            }
        });
    }
}

// The sums of a step have one order whatever the registers: products by lanes and by plain loops.
TEST(StageLanes, products_do_not_depend_on_registers) {
    const GaussWeights<double> weights(GaussMatrices(0.3L), 1.7);
    std::array<PlainLanes<double, stage_count>, stage_count> columns;
    alignas(64) double numbers[stage_count] = {1, -0.3, 0.7, 1e-3, 5, -2, 0.1, 1.7}, column[stage_count];
    for (std::size_t j = 0; j < stage_count; ++j) {
        weights.stage[j].store(column);
        columns[j] = PlainLanes<double, stage_count>::load(column);
    }
    const auto lanes = product(weights.stage, numbers);
    const auto plain = product(columns, numbers);
    for (std::size_t i = 0; i < stage_count; ++i) EXPECT_EQ(lanes[i], plain[i]);
}

}  // namespace
}  // namespace steplab::test
