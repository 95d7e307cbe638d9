#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/text_trajectory.hpp"
#include "io/values_of_rows.hpp"
#include "io/words.hpp"
#include "io/xyz_comment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// What a word of a row is.
enum class Word { number, momentum, mass, role, perhaps_role, value, other };
struct Place {
    Word word = Word::other;
    Column column = Column::x;  ///< of a number, or a momentum
    std::size_t value = 0;      ///< the number of its column among those of no meaning here
};

struct Property {
    std::string_view name;
    std::size_t words;
    Word word;
    Column column = Column::x;  ///< of its first word
};

constexpr std::array properties{
    Property{"pos", 3, Word::number, Column::x},
    Property{"velo", 3, Word::number, Column::vx},
    Property{"disp", 3, Word::number, Column::ux},
    Property{"momenta", 3, Word::momentum, Column::vx},
    Property{"masses", 1, Word::mass},
    Property{"role", 1, Word::role},
    Property{"type", 1, Word::perhaps_role},  // of steplab 0.2; elsewhere anything
};

/// "charge"; of a vector "forces_x", of more "tensor_4".
std::string name_of_part(const std::string& name, std::uint64_t part, std::uint64_t parts) {
    if (parts == 1) return name;
    return parts == 3 ? fmt::format("{}_{}", name, "xyz"[part]) : fmt::format("{}_{}", name, part + 1);
}

class XyzTrajectory final : public TextTrajectory {
public:
    XyzTrajectory(TextInput input, From from) : TextTrajectory(std::move(input)), foreign_(from == From::any_program) {
        read_head();
    }

private:
    bool read(FrameBlock& frame) override {
        if (std::exchange(used_, true)) read_head();
        if (!has_head_) return false;
        frame.scene = scene_;
        frame.moments.push_back(moment_);
        for (std::uint64_t row = 0; row < rows_; ++row) {
            const auto line = input_.line();
            if (!line) input_.fail(fmt::format("it ends after {} of the {} rows of a frame", row, rows_));
            split(*line, words_);
            read_row(frame, words_);
        }
        values_.put_into(frame.values);
        if (foreign_ && frame.masses.size() == frame.rows) take_momenta(frame);
        if (frame.roles.size() != frame.rows) frame.roles.clear();
        if (!same_mass_) frame.scene.mass = 0;
        if (same_mass_ && !foreign_) frame.masses.clear();  // of a scene, they are kept where they differ
        return true;
    }

    void read_row(FrameBlock& frame, const std::vector<std::string_view>& words) {
        if (words.size() != places_.size())
            input_.fail(
                fmt::format("it has {} columns; by its Properties it should have {}", words.size(), places_.size()));
        add_row(frame);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const Place& place = places_[i];
            if (place.word == Word::number || place.word == Word::momentum) set(frame, place.column, words[i]);
            if (place.word == Word::mass) set_mass(frame, number<double>(words[i]));
            if (place.word == Word::value) values_.add(place.value, words[i]);
            if (place.word != Word::role && place.word != Word::perhaps_role) continue;
            const auto role = parse_role(words[i]);
            if (role) frame.roles.push_back(*role);
            if (!role && place.word == Word::role) input_.fail(unknown_word("role", words[i], role_ids));
        }
    }

    /// All particles have one mass, or each its own.
    void set_mass(FrameBlock& frame, double mass) {
        if (frame.rows == 1) frame.scene.mass = mass, same_mass_ = true;
        same_mass_ = same_mass_ && frame.scene.mass == mass;
        frame.masses.push_back(mass);
    }

    /// As velocities, where the file has no others.
    void take_momenta(FrameBlock& frame) const {
        if (!momenta_) return;
        for (std::size_t i = 0; i < frame.rows; ++i) {
            if (!(frame.masses[i] > 0)) input_.fail("momenta need masses > 0");
            frame.velocities[i] = 1 / frame.masses[i] * frame.velocities[i];
        }
    }

    /// The two lines before the rows of a frame.
    void read_head() {
        const auto count = input_.line();
        has_head_ = count.has_value() && !words_of(*count).empty();
        if (!has_head_) return check_end();
        rows_ = number<std::uint64_t>(words_of(*count).front());
        if (rows_ == 0) input_.fail("a frame has no rows");
        const auto comment = input_.line();
        const XyzComment pairs(comment.value_or(""));
        const auto value = [&](std::string_view key, std::string_view otherwise = "") -> std::string {
            if (const auto known = pairs.value(key)) return *known;
            if (!foreign_ || otherwise.empty()) input_.fail(fmt::format("the line of a frame has no {}=", key));
            return std::string(otherwise);
        };
        moment_ = {number<std::uint64_t>(value("Step", std::to_string(heads_++))), number<double>(value("Time", "0"))};
        scene_ = {};
        if (pairs.value("Precision") == id(Precision::float_)) scene_.precision = Precision::float_;
        if (pairs.value("Lattice"))
            read_box(value("Lattice"), value("Origin", "0 0 0"), pairs.value("pbc").value_or("T T T"));
        read_properties(value("Properties", "species:S:1:pos:R:3"));
    }

    /// Behind an empty line, of which some programs write one at the end.
    void check_end() {
        while (const auto line = input_.line()) {
            if (!words_of(*line).empty()) input_.fail("a frame cannot follow an empty line");
        }
    }

    /// A box along the axes, through all faces of which the space goes on, is all that a scene has; that of another
    /// program may lean, or have faces.
    void read_box(std::string_view lattice, std::string_view origin, std::string_view periodic) {
        const bool has_faces = periodic.find('F') != std::string_view::npos;
        if (foreign_ && (!is_along_axes(lattice) || has_faces)) return read_cell(lattice, origin, periodic);
        const auto edges = words_of(lattice), corner = words_of(origin);
        if (edges.size() != 9 || corner.size() != 3) input_.fail("its Lattice or Origin is not one of steplab");
        std::array<double, 3> sides{};
        for (std::size_t i = 0; i < 9; ++i) {
            const double edge = number<double>(edges[i]);
            if (i % 4 == 0) sides[i / 4] = edge;
            if (i % 4 == 0 ? !(edge >= 0) : edge != 0) input_.fail("its Lattice is not a box along the axes");
        }
        scene_.box = {sides[0], sides[1], sides[2]};
        if (scene_.box == Vec3{}) input_.fail("its Lattice is not a box along the axes");
        scene_.corner = {number<double>(corner[0]), number<double>(corner[1]), number<double>(corner[2])};
    }

    /// One that is flat, or of another form, is left out.
    void read_cell(std::string_view lattice, std::string_view origin, std::string_view periodic) {
        const auto edges = words_of(lattice), corner = words_of(origin), flags = words_of(periodic);
        if (edges.size() != 9 || corner.size() != 3) return;
        Cell cell{.corner = vector_at(corner, 0)};
        for (std::size_t edge = 0; edge < 3; ++edge) {
            cell.edges[edge] = vector_at(edges, 3 * edge);
            cell.periodic[edge] = flags.size() != 3 || flags[edge] == "T";
        }
        if (cell.is_whole()) scene_.cell = cell;
    }

    Vec3 vector_at(const std::vector<std::string_view>& words, std::size_t first) const {
        return {number<double>(words[first]), number<double>(words[first + 1]), number<double>(words[first + 2])};
    }

    bool is_along_axes(std::string_view lattice) const {
        const auto edges = words_of(lattice);
        bool along = edges.size() == 9;
        for (std::size_t i = 0; along && i < 9; ++i) along = i % 4 == 0 || number<double>(edges[i]) == 0;
        for (std::size_t i = 0; along && i < 9; i += 4) along = number<double>(edges[i]) > 0;
        return along;
    }

    void read_properties(const std::string& text) {
        if (text == properties_) return;
        if (!properties_.empty()) input_.fail("its Properties are not those of the frame before");
        properties_ = text;
        std::vector<std::string> parts(1);
        for (const char c : text) c == ':' ? parts.emplace_back() : parts.back().append(1, c);
        use_momenta_ = foreign_ && std::find(parts.begin(), parts.end(), "velo") == parts.end();
        if (parts.size() % 3 != 0) input_.fail("its Properties are not name:type:count ...");
        for (std::size_t i = 0; i < parts.size(); i += 3)
            add_places(parts[i], parts[i + 1], number<std::uint64_t>(parts[i + 2]));
        if (momenta_ && !with_masses_) input_.fail("momenta need masses");
        if (columns_.empty()) input_.fail("its Properties name none of pos, velo and disp");
    }

    void add_places(const std::string& name, std::string_view type, std::uint64_t words) {
        constexpr std::uint64_t most = 64;
        if (words == 0 || words > most) input_.fail(fmt::format("{} has {} columns", shown(name), words));
        const auto known = std::find_if(properties.begin(), properties.end(), [&](const Property& property) {
            return property.name == name && property.words == words;
        });
        for (std::uint64_t i = 0; i < words; ++i) {
            Place place;
            if (known != properties.end())
                place = {known->word, static_cast<Column>(static_cast<std::uint64_t>(known->column) + i)};
            if (place.word == Word::momentum && !use_momenta_) place.word = Word::other;
            const bool number = place.word == Word::number || place.word == Word::momentum;
            if (number && contains(columns_, place.column))
                input_.fail(fmt::format("its Properties name {} twice", shown(name)));
            if (number) columns_.push_back(place.column);
            if (known == properties.end() && foreign_ && (type == "R" || type == "I")) {
                place.word = Word::value;
                place.value = values_.column(name_of_part(name, i, words));
            }
            momenta_ = momenta_ || place.word == Word::momentum;
            with_masses_ = with_masses_ || place.word == Word::mass;
            places_.push_back(place);
        }
    }

    bool foreign_;
    bool has_head_ = false, used_ = false;  ///< the head that was read last
    std::uint64_t heads_ = 0;
    std::vector<std::string_view> words_;
    bool use_momenta_ = false, momenta_ = false, with_masses_ = false;
    std::uint64_t rows_ = 0;
    FrameBlock::Moment moment_;
    FileScene scene_;
    std::string properties_;
    std::vector<Place> places_;  ///< of each word of a row
    ValuesOfRows values_;
    bool same_mass_ = false;
};

}  // namespace

std::unique_ptr<TextTrajectory> xyz_trajectory(TextInput input, TextTrajectory::From from) {
    return std::make_unique<XyzTrajectory>(std::move(input), from);
}

}  // namespace steplab
