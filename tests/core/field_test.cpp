#include "core/field.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace steplab {
namespace {

TEST(Field, is_zero_at_first_with_its_padding) {
    const Field<float> field(10);
    EXPECT_EQ(field.flat().size() % Field<float>::granule, 0u);
    for (const float number : field.flat()) EXPECT_EQ(number, 0.0f);
}

TEST(Field, each_component_starts_on_a_cache_line) {
    for (std::size_t count : {1u, 10u, 16u, 17u, 1000u}) {
        Field<double> field(count);
        for (const double* component : {field.x(), field.y(), field.z()}) {
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(component) % 64, 0u) << count;
        }
    }
}

TEST(Field, holds_vectors_by_particle) {
    Field<double> field(3);
    field.set(1, {1, 2, 3});
    EXPECT_EQ(field.at(1), (Vec3{1, 2, 3}));
    EXPECT_EQ(field.at(0), Vec3{});
    EXPECT_EQ(field.y()[1], 2);
}

TEST(Field, conversion_rounds_each_number_once) {
    Field<double> field(2);
    field.set(1, {0.1, -0.2, 1e300});
    const Field<float> rounded = converted<float>(field);
    EXPECT_EQ(rounded.x()[1], 0.1f);
    EXPECT_EQ(rounded.y()[1], -0.2f);
    EXPECT_EQ(converted<double>(rounded).x()[1], static_cast<double>(0.1f));
}

}  // namespace
}  // namespace steplab
