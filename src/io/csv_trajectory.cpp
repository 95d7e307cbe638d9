#include "core/error.hpp"
#include "io/csv_line.hpp"
#include "io/text_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        fields.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return fields;
}

class CsvTrajectory final : public TextTrajectory {
public:
    /// The lines of these columns, without the first one.
    CsvTrajectory(TextInput input, Columns columns) : TextTrajectory(std::move(input)) {
        columns_ = std::move(columns);
        take_line();
    }

private:
    /// A frame ends where the step changes, or where its particles begin again.
    bool read(FrameBlock& frame) override {
        if (!has_line_) return false;
        CsvBegin before = begin_;
        frame.moments.push_back(before.moment);
        do {
            add_row(frame);
            for (std::size_t i = 0; i < columns_.size(); ++i) set(frame, columns_[i], fields_[i + 3]);
            frame.particles.push_back(begin_.particle);
            before = begin_;
            take_line();
        } while (has_line_ && begin_.follows(before));
        if (has_line_ && begin_.is_out_of_order(before, frame.particles.front()))
            input_.fail(begin_.order_text(before));
        return true;
    }

    void take_line() {
        const auto line = input_.line();
        has_line_ = line.has_value();
        if (!line) return;
        line_ = *line;
        fields_ = fields_of(line_);
        if (fields_.size() != columns_.size() + 3)
            input_.fail(fmt::format("it has {} fields, the first line {}", fields_.size(), columns_.size() + 3));
        begin_.moment = {number<std::uint64_t>(fields_[0]), number<double>(fields_[1])};
        begin_.particle = number<std::uint64_t>(fields_[2]);
    }

    bool has_line_ = false;
    std::string line_;
    std::vector<std::string_view> fields_;  ///< of the line, which is the next to be used
    CsvBegin begin_;
};

}  // namespace

std::unique_ptr<TextTrajectory> csv_trajectory(TextInput input) {
    const std::string head(input.line().value_or(""));
    Columns columns;
    try {
        columns = columns_of_csv(head);
    } catch (const UsageError& error) {
        input.fail(error.what());
    }
    return csv_trajectory(std::move(input), std::move(columns));
}

std::unique_ptr<TextTrajectory> csv_trajectory(TextInput rows, Columns columns) {
    return std::make_unique<CsvTrajectory>(std::move(rows), std::move(columns));
}

}  // namespace steplab
