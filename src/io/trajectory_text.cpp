#include "io/trajectory_text.hpp"

#include "core/text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstring>

namespace steplab {

namespace {

/// A line being built. The buffer is long enough for any: a number takes at most 24 characters.
class Line {
public:
    void clear() { end_ = text_; }
    void add(char c) { *end_++ = c; }
    void add(std::string_view word) {
        std::memcpy(end_, word.data(), word.size());
        end_ += word.size();
    }
    template <class Number>
    void add_number(Number value) {
        end_ = std::to_chars(end_, text_ + sizeof text_, value).ptr;
    }
    template <class Number>
    void add_vector(char separator, Vec3 v) {
        for (const double value : {v.x, v.y, v.z}) {
            add(separator);
            add_number(static_cast<Number>(value));
        }
    }
    void append_to(std::string& text) const { text.append(text_, static_cast<std::size_t>(end_ - text_)); }

private:
    char text_[512];
    char* end_ = text_;
};

/// Appends a line for each row of one frame; `begin_line(line, row)` adds what precedes position and velocity.
template <class Number, class BeginLine>
void append_rows(std::string& text, const FrameBlock& block, std::size_t moment, char separator,
                 const BeginLine& begin_line) {
    Line line;
    for (std::size_t row = 0; row < block.rows; ++row) {
        line.clear();
        begin_line(line, block.first_row + row);
        line.add_vector<Number>(separator, block.positions[moment * block.rows + row]);
        line.add_vector<Number>(separator, block.velocities[moment * block.rows + row]);
        line.add('\n');
        line.append_to(text);
    }
}

template <class BeginLine>
void append_rows(std::string& text, const FrameBlock& block, std::size_t moment, char separator,
                 const BeginLine& begin_line) {
    if (block.precision == Precision::float_) {
        append_rows<float>(text, block, moment, separator, begin_line);
    } else {
        append_rows<double>(text, block, moment, separator, begin_line);
    }
}

/// The periodic box, or that there is none, in the words of extended XYZ.
std::string box_text(const Shape& shape) {
    if (shape.period == 0) return "pbc=\"F F F\"";
    const std::string edge = number_text(shape.period);
    return fmt::format("Lattice=\"{0} 0 0 0 {0} 0 0 0 {0}\" Origin=\"{1} {2} {3}\" pbc=\"T T T\"", edge,
                       number_text(shape.corner.x), number_text(shape.corner.y), number_text(shape.corner.z));
}

}  // namespace

void append_csv(std::string& text, const FrameBlock& block) {
    for (std::size_t i = 0; i < block.moments.size(); ++i) {
        const std::string moment = fmt::format("{},{},", block.moments[i].step, number_text(block.moments[i].time));
        append_rows(text, block, i, ',', [&](Line& line, std::size_t row) {
            line.add(moment);
            line.add_number(block.particle(row));
        });
    }
}

void append_xyz(std::string& text, const FrameBlock& block) {
    for (std::size_t i = 0; i < block.moments.size(); ++i) {
        if (block.first_row == 0) {
            text += fmt::format("{}\nProperties=type:S:1:pos:R:3:velo:R:3 Time={} Step={} {}\n", block.frame_rows,
                                number_text(block.moments[i].time), block.moments[i].step, box_text(*block.shape));
        }
        append_rows(text, block, i, ' ', [&](Line& line, std::size_t row) { line.add(id(block.role(row))); });
    }
}

}  // namespace steplab
