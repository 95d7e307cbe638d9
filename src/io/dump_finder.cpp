#include "core/error.hpp"
#include "io/dump_trajectory.hpp"
#include "io/frame_finder.hpp"
#include "io/words.hpp"

#include <fmt/format.h>

#include <utility>

namespace steplab {

namespace {

/// Of a LAMMPS dump. Its steps may not go back: the time line would.
class DumpFinder final : public FrameFinder {
public:
    void take(const Line& line, std::vector<FoundFrame>& found) override {
        if (next_ == Next::item) return take_item(line);
        if (next_ == Next::step) frame_.moment.step = number_of<std::uint64_t>(line, word_of(line.text));
        if (next_ == Next::rows) frame_.rows = number_of<std::uint64_t>(line, word_of(line.text));
        if (next_ == Next::time) time_ = number_of<double>(line, word_of(line.text));
        if (--left_ > 0) return;
        if (next_ == Next::row) found.push_back(frame_until(line));
        next_ = Next::item;
    }

    bool may_end_with(std::string_view) const override { return next_ == Next::row && left_ == 1; }
    bool within() const override { return within_; }
    std::unique_ptr<TextTrajectory> reader(TextInput frame) const override {
        return std::make_unique<DumpTrajectory>(std::move(frame));
    }

private:
    /// What the next line is.
    enum class Next { item, step, time, rows, other, row };

    static std::string_view word_of(std::string_view line) {
        const auto words = words_of(line);
        return words.size() == 1 ? words[0] : line;
    }

    void take_item(const Line& line) {
        constexpr std::string_view begin = "ITEM: ";
        std::string_view item = line.text;
        if (!item.starts_with(begin)) {
            if (!words_of(item).empty()) line.fail("a frame of a LAMMPS dump begins with ITEM: TIMESTEP");
            return;
        }
        item.remove_prefix(begin.size());
        if (!within_) frame_ = {.begin = line.begin, .line = line.number}, time_.reset();
        within_ = true;
        next_ = kind_of(item);
        left_ = next_ == Next::row ? frame_.rows : item.starts_with("BOX BOUNDS") ? 3 : 1;
        if (left_ == 0) line.fail("a frame has no atoms");
    }

    static Next kind_of(std::string_view item) {
        if (item == "TIMESTEP") return Next::step;
        if (item == "TIME") return Next::time;
        if (item == "NUMBER OF ATOMS") return Next::rows;
        return item.starts_with("ATOMS") ? Next::row : Next::other;
    }

    FoundFrame frame_until(const Line& line) {
        within_ = false;
        frame_.end = line.end;
        frame_.moment.time = time_.value_or(static_cast<double>(frame_.moment.step));
        if (frame_.moment.step < last_step_)
            throw FileError(fmt::format("line {}: the frame that begins here is of step {}, the one before of step {}",
                                        frame_.line + 1, frame_.moment.step, last_step_));
        last_step_ = frame_.moment.step;
        return frame_;
    }

    Next next_ = Next::item;
    std::uint64_t left_ = 0;  ///< lines of this kind
    FoundFrame frame_;
    std::optional<double> time_;
    std::uint64_t last_step_ = 0;
    bool within_ = false;
};

}  // namespace

std::unique_ptr<FrameFinder> dump_finder() { return std::make_unique<DumpFinder>(); }

}  // namespace steplab
