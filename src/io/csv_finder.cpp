#include "core/error.hpp"
#include "io/csv_line.hpp"
#include "io/frame_finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace steplab {

namespace {

/// Of CSV, of which a frame ends where the step changes, or where its particles begin again: only the first fields of a
/// line are read. Once its rows are known from the first one, a frame is complete with its last row.
class CsvFinder final : public FrameFinder {
public:
    void take(const Line& line, std::vector<FoundFrame>& found) override {
        if (line.number == 0) return take_head(line);
        const CsvBegin row = begin_of(line);
        if (frame_.rows > 0 && row.follows(last_)) {
            if (!is_open_) line.fail(fmt::format("a frame has more rows than the {} of the first one", rows_));
            ++frame_.rows;
        } else {
            if (frame_.rows > 0 && row.is_out_of_order(last_, first_)) line.fail(row.order_text(last_));
            if (is_open_) found.push_back(frame_until(line.begin));
            first_ = row.particle;
            frame_ = {.begin = line.begin, .line = line.number, .moment = row.moment, .rows = 1};
            is_open_ = true;
        }
        remember(row);
        end_ = line.end;
        if (is_open_ && frame_.rows == rows_) found.push_back(frame_until(end_));
    }

    bool may_end_with(std::string_view line) const override {
        return static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) == columns_.size() + 2;
    }
    std::optional<FoundFrame> at_end() override {
        return rows_ == 0 && is_open_ ? std::optional(frame_until(end_)) : std::nullopt;
    }
    bool within() const override { return is_open_; }
    std::unique_ptr<TextTrajectory> reader(TextInput frame) const override {
        return csv_trajectory(std::move(frame), columns_);
    }

private:
    void take_head(const Line& line) {
        try {
            columns_ = columns_of_csv(line.text);
        } catch (const Error& error) {
            line.fail(error.what());
        }
    }

    /// Most lines are of the moment of the line before, which need not be read again.
    CsvBegin begin_of(const Line& line) const {
        if (const auto row = csv_begin_after(last_, line.text)) return *row;
        const auto row = csv_begin(line.text);
        if (!row) line.fail("it does not begin with the numbers of a step, a time and a particle");
        return *row;
    }

    /// Its text goes with the line.
    void remember(const CsvBegin& row) {
        moment_text_.assign(row.moment_text);
        last_ = row;
        last_.moment_text = moment_text_;
    }

    FoundFrame frame_until(std::uint64_t end) {
        frame_.end = end;
        is_open_ = false;
        if (rows_ == 0) rows_ = frame_.rows;
        return frame_;
    }

    Columns columns_;
    FoundFrame frame_;  ///< that is looked at; no rows: none
    bool is_open_ = false;
    std::uint64_t rows_ = 0;   ///< of the first frame; 0: not known
    CsvBegin last_;            ///< of the line before
    std::uint64_t first_ = 0;  ///< particle of the frame
    std::string moment_text_;
    std::uint64_t end_ = 0;  ///< of that line
};

}  // namespace

std::unique_ptr<FrameFinder> csv_finder() { return std::make_unique<CsvFinder>(); }

}  // namespace steplab
