#pragma once

#include "io/columns.hpp"
#include "io/frame_block.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// The begin of a line of CSV: "step,time,particle,".
struct CsvBegin {
    std::string_view moment_text = {};  ///< "step,time,"
    FrameBlock::Moment moment = {};
    std::uint64_t particle = 0;

    /// True if it is a row of the frame of the line before.
    bool follows(const CsvBegin& before) const { return is_of_moment(before) && particle > before.particle; }
    /// True if it is one of that frame, which began with the particle `first`, in the wrong place; where its particles
    /// begin again, it is a row of another one.
    bool is_out_of_order(const CsvBegin& before, std::uint64_t first) const {
        return is_of_moment(before) && particle <= before.particle && particle != first;
    }
    /// What is wrong then.
    std::string order_text(const CsvBegin& before) const {
        return fmt::format("particle {} stands behind particle {}: the rows of a step must be in ascending order",
                           particle, before.particle);
    }
    bool is_of_moment(const CsvBegin& before) const {
        return moment.step == before.moment.step && moment.time == before.moment.time;
    }
};

/// None if the line does not begin so.
std::optional<CsvBegin> csv_begin(std::string_view line);
/// The same where the line has the moment of the line before, letter by letter; none if not.
std::optional<CsvBegin> csv_begin_after(const CsvBegin& before, std::string_view line);

/// Those behind the particle in the first line of a file. Throws UsageError.
Columns columns_of_csv(std::string_view head);

}  // namespace steplab
