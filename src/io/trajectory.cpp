#include "io/trajectory.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/number_append.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

namespace steplab {

namespace {

constexpr std::array<std::string_view, 2> format_names{"csv", "xyz"};
constexpr std::string_view csv_header = "step,time,particle,x,y,z,vx,vy,vz\n";

/// Rows made at once by one thread: about a megabyte of text.
constexpr std::size_t rows_in_block = 8192;

struct Row {
    std::size_t particle = 0;
    Role role = Role::moving;
    Vec3 position;
    Vec3 velocity;
};

void append_vector(std::string& text, Vec3 v, Precision precision, char separator) {
    for (const double value : {v.x, v.y, v.z}) {
        text += separator;
        if (precision == Precision::float_) {
            append_number(text, static_cast<float>(value));
        } else {
            append_number(text, value);
        }
    }
}

}  // namespace

/// Consecutive rows of one or more frames, or of a part of a frame.
struct TrajectoryWriter::Block {
    struct Part {
        std::uint64_t step = 0;
        double time = 0;
        std::size_t frame_rows = 0;  ///< of the whole frame
        bool frame_begins = false;
        std::size_t rows = 0;  ///< of the frame in this block
    };

    TrajectoryFormat format = TrajectoryFormat::csv;
    Precision precision = Precision::double_;
    std::vector<Part> parts;
    std::vector<Row> rows;

    std::string text() const;

private:
    void append_csv(std::string& text, const Part& part, const Row* row) const;
    void append_xyz(std::string& text, const Part& part, const Row* row) const;
};

std::string TrajectoryWriter::Block::text() const {
    std::string text;
    text.reserve(rows.size() * 160);
    const Row* row = rows.data();
    for (const Part& part : parts) {
        if (format == TrajectoryFormat::csv) {
            append_csv(text, part, row);
        } else {
            append_xyz(text, part, row);
        }
        row += part.rows;
    }
    return text;
}

void TrajectoryWriter::Block::append_csv(std::string& text, const Part& part, const Row* row) const {
    const std::string moment = fmt::format("{},{},", part.step, number_text(part.time));
    for (const Row* end = row + part.rows; row != end; ++row) {
        text += moment;
        append_number(text, row->particle);
        append_vector(text, row->position, precision, ',');
        append_vector(text, row->velocity, precision, ',');
        text += '\n';
    }
}

void TrajectoryWriter::Block::append_xyz(std::string& text, const Part& part, const Row* row) const {
    if (part.frame_begins) {
        text += fmt::format("{}\nProperties=type:S:1:pos:R:3:velo:R:3 Time={} Step={} pbc=\"F F F\"\n", part.frame_rows,
                            number_text(part.time), part.step);
    }
    for (const Row* end = row + part.rows; row != end; ++row) {
        text += id(row->role);
        append_vector(text, row->position, precision, ' ');
        append_vector(text, row->velocity, precision, ' ');
        text += '\n';
    }
}

TrajectoryWriter::TrajectoryWriter(OutputFile& file, TrajectoryFormat format, std::vector<std::size_t> particles)
    : writer_(file), format_(format), particles_(std::move(particles)) {
    if (format == TrajectoryFormat::csv) file.write(csv_header);
}

TrajectoryWriter::~TrajectoryWriter() = default;

void TrajectoryWriter::add(const Frame& frame) {
    const std::size_t count = particles_.empty() ? frame.positions.size() : particles_.size();
    for (std::size_t done = 0; done < count;) {
        if (!block_) block_ = std::make_shared<Block>(Block{format_, frame.precision, {}, {}});
        const std::size_t rows = std::min(count - done, rows_in_block - block_->rows.size());
        block_->parts.push_back({frame.step, frame.time, count, done == 0, rows});
        for (const std::size_t end = done + rows; done < end; ++done) {
            const std::size_t i = particles_.empty() ? done : particles_[done];
            block_->rows.push_back({i, frame.shape->roles[i], frame.positions[i], frame.velocities[i]});
        }
        if (block_->rows.size() == rows_in_block) submit();
    }
}

void TrajectoryWriter::submit() {
    if (block_) writer_.submit([block = std::exchange(block_, nullptr)] { return block->text(); });
}

void TrajectoryWriter::flush() {
    submit();
    writer_.drain();
}

TrajectoryFormat trajectory_format(std::string_view name) {
    const auto found = std::find(format_names.begin(), format_names.end(), name);
    if (found == format_names.end()) throw UsageError(unknown_word("format", name, format_names));
    return static_cast<TrajectoryFormat>(found - format_names.begin());
}

TrajectoryFormat trajectory_format_of(const std::string& file) {
    std::error_code ignored;  // a folder is refused as such when it is opened
    if (written_directly(file) || std::filesystem::is_directory(file, ignored)) return TrajectoryFormat::csv;
    std::string ending = std::filesystem::path(file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (!ending.empty()) ending.erase(0, 1);
    const auto found = std::find(format_names.begin(), format_names.end(), ending);
    if (found == format_names.end()) {
        throw UsageError(fmt::format("the ending of '{}' names no format: end it in .{}, or say --format {}", file,
                                     joined(format_names, " or ."), joined(format_names, " or --format ")));
    }
    return static_cast<TrajectoryFormat>(found - format_names.begin());
}

}  // namespace steplab
