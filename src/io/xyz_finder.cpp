#include "io/frame_finder.hpp"
#include "io/words.hpp"
#include "io/xyz_comment.hpp"

#include <string>
#include <utility>

namespace steplab {

namespace {

/// Of XYZ, extended or not.
class XyzFinder final : public FrameFinder {
public:
    void take(const Line& line, std::vector<FoundFrame>& found) override {
        if (next_ == Next::count) return take_count(line);
        if (next_ == Next::comment) return take_comment(line);
        if (--left_ > 0) return;
        next_ = Next::count;
        frame_.end = line.end;
        found.push_back(frame_);
    }

    bool may_end_with(std::string_view) const override { return next_ == Next::row && left_ == 1; }
    bool within() const override { return next_ != Next::count; }
    std::unique_ptr<TextTrajectory> reader(TextInput frame) const override {
        return xyz_trajectory(std::move(frame), TextTrajectory::From::any_program);
    }

private:
    /// What the next line is.
    enum class Next { count, comment, row };

    /// Behind an empty line, of which some programs write one at the end, no frame can follow.
    void take_count(const Line& line) {
        const auto words = words_of(line.text);
        if (words.empty()) {
            ended_ = true;
            return;
        }
        if (ended_) line.fail("a frame cannot follow an empty line");
        frame_ = {.begin = line.begin, .line = line.number, .rows = number_of<std::uint64_t>(line, words[0])};
        left_ = frame_.rows;
        if (left_ == 0) line.fail("a frame has no rows");
        next_ = Next::comment;
    }

    void take_comment(const Line& line) {
        const XyzComment comment(line.text);
        const std::uint64_t number = frames_++;
        const auto step = comment.value("Step"), time = comment.value("Time");
        frame_.moment.step = step ? number_of<std::uint64_t>(line, *step) : number;
        frame_.moment.time = time ? number_of<double>(line, *time) : 0;
        next_ = Next::row;
    }

    Next next_ = Next::count;
    std::uint64_t left_ = 0;  ///< rows
    std::uint64_t frames_ = 0;
    FoundFrame frame_;
    bool ended_ = false;
};

}  // namespace

std::unique_ptr<FrameFinder> xyz_finder() { return std::make_unique<XyzFinder>(); }

}  // namespace steplab
