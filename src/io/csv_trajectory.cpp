#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/text_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
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
    explicit CsvTrajectory(TextInput input) : TextTrajectory(std::move(input)) {
        constexpr std::string_view begin = "step,time,particle,";
        const std::string_view head = input_.line().value_or("");
        if (!head.starts_with(begin)) input_.fail("it has no columns of numbers behind step,time,particle");
        try {
            columns_ = parse_columns(head.substr(begin.size()));
        } catch (const UsageError& error) {
            input_.fail(error.what());
        }
        take_line();
    }

private:
    /// The numbers before those of the columns.
    struct Begin {
        FrameBlock::Moment moment;
        std::uint64_t particle = 0;
    };

    /// A frame ends where the step changes, or where its particles begin again.
    bool read(FrameBlock& frame) override {
        if (!has_line_) return false;
        const Begin first = begin_;
        frame.moments.push_back(first.moment);
        do {
            add_row(frame);
            for (std::size_t i = 0; i < columns_.size(); ++i) set(frame, columns_[i], fields_[i + 3]);
            frame.particles.push_back(begin_.particle);
            take_line();
        } while (has_line_ && begin_.moment.step == first.moment.step && begin_.moment.time == first.moment.time &&
                 begin_.particle > frame.particles.back());
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
        begin_ = {{number<std::uint64_t>(fields_[0]), number<double>(fields_[1])}, number<std::uint64_t>(fields_[2])};
    }

    bool has_line_ = false;
    std::string line_;
    std::vector<std::string_view> fields_;  ///< of the line, which is the next to be used
    Begin begin_;
};

}  // namespace

std::unique_ptr<TextTrajectory> csv_trajectory(TextInput input) {
    return std::make_unique<CsvTrajectory>(std::move(input));
}

}  // namespace steplab
