#pragma once

#include "io/text_trajectory.hpp"
#include "io/values_of_rows.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// Reads the frames of a LAMMPS dump (`dump custom` and `dump atom`, as text) from front to back: atoms in any order,
/// which are sorted by their ids, coordinates as they are, scaled or unwrapped, with image flags, in boxes that may
/// change and be tilted. A particle has the number id - 1. Times are those of ITEM: TIME; without, that of step N is
/// N s. Columns may differ from frame to frame. What else there is of numbers
/// goes into values.
class DumpTrajectory final : public TextTrajectory {
public:
    /// True if a text that begins like this is one.
    static bool begins(std::string_view text) { return text.starts_with("ITEM:"); }

    /// Reads the head of the first frame. Throws FileError.
    explicit DumpTrajectory(TextInput input);

    /// Forces on the atoms of the last frame, in the units of the dump; empty if it has none.
    const std::vector<Vec3>& forces() const { return forces_; }

private:
    /// Where in a row a coordinate is, and what it is.
    struct Coordinate {
        std::size_t word = 0;
        bool scaled = false;
        std::optional<std::size_t> image = {};  ///< the word with the number of the box
    };
    /// The lowest corner of a box and its edges, which may lean.
    struct Box {
        Vec3 low;
        std::array<Vec3, 3> edges{};
        std::array<bool, 3> periodic{};
        bool leans = false;
    };

    bool read(FrameBlock& frame) override;
    bool read_head();
    void know_columns();
    void read_item(std::string_view item);
    std::string_view next_line();
    std::vector<std::string_view> numbers_line(std::size_t least);
    void read_box(std::string_view item);
    void read_bounds(bool tilted);
    void read_edges();
    void put_box(FileScene& scene) const;
    void read_columns(std::string_view names);
    void read_other_columns();
    std::optional<std::size_t> column(std::string_view name) const;
    std::optional<std::array<std::size_t, 3>> vector_of(char letter) const;
    Vec3 vector_in(const std::array<std::size_t, 3>& words) const;
    Coordinate coordinate(char axis) const;
    void read_row(FrameBlock& frame, std::string_view line);
    Vec3 position() const;
    void sort(FrameBlock& frame);

    bool used_ = false;  ///< the head that was read last
    bool has_head_ = false, has_step_ = false, has_rows_ = false, has_box_ = false;
    std::optional<double> time_;
    std::string units_;  ///< said once, at the begin of the file
    FrameBlock::Moment moment_;
    std::uint64_t rows_ = 0;
    Box box_;
    std::vector<std::string> names_;  ///< of the columns
    std::array<Coordinate, 3> coordinates_;
    std::optional<std::array<std::size_t, 3>> velocity_, force_;
    std::optional<std::size_t> id_, type_, mass_;
    std::vector<std::string_view> words_;  ///< of a row
    ValuesOfRows values_;
    std::vector<std::size_t> others_;  ///< the words that are in values_
    std::vector<std::uint64_t> ids_;
    std::vector<Vec3> forces_;
};

}  // namespace steplab
