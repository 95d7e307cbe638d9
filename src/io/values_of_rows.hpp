#pragma once

#include "core/particle_values.hpp"
#include "io/number_read.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

/// Collects the columns of numbers of a frame, row by row, that no position, velocity or mass is made of.
class ValuesOfRows {
public:
    /// Another column; its number.
    std::size_t column(std::string name) {
        columns_.push_back({.name = std::move(name), .values = {}});
        return columns_.size() - 1;
    }
    /// The word of the next row. What is no number is a missing one.
    void add(std::size_t column, std::string_view word) {
        columns_[column].values.push_back(number_in<double>(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    /// Hands over the values that were added. A column without any number, as of names, is left out.
    void put_into(std::vector<ParticleValues>& values) {
        for (ParticleValues& column : columns_) {
            const bool has_numbers = std::any_of(column.values.begin(), column.values.end(),
                                                 [](double value) { return !std::isnan(value); });
            if (has_numbers) values.push_back({.name = column.name, .values = std::move(column.values)});
            column.values.clear();
        }
    }
    void clear() { columns_.clear(); }

private:
    std::vector<ParticleValues> columns_;
};

}  // namespace steplab
