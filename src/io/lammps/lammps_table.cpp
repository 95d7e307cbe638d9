#include "io/lammps/lammps_table.hpp"

#include "io/number_append.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace steplab {

namespace {

constexpr int fewest_bits = 12, most_bits = 16, bitmap_bits = 18;
constexpr double wanted_error = 1e-10;
/// r^2 is a float in LAMMPS' bitmapped tables; a force that falls as r^-7 has seven halves of its rounding.
constexpr double rounding_of_floats = 4e-7;

/// The squares of the distances of a bitmapped table, as Pair::init_bitmap() and PairTable::read_table() of LAMMPS
/// choose them.
class Bitmap {
public:
    Bitmap(double low, double high, int bits) : low_(low) {
        const int lowest = std::ilogb(low * low);
        const double wanted = high * high / std::ldexp(1.0, lowest);
        int exponent_bits = 0;
        while (std::exp2(std::exp2(exponent_bits)) < wanted) ++exponent_bits;
        const int mantissa_bits = bits - exponent_bits;
        shift_ = std::numeric_limits<float>::digits - (mantissa_bits + 1);
        const std::uint32_t mask = (1U << (bits + shift_)) - 1U;
        from_ = std::bit_cast<std::uint32_t>(static_cast<float>(low * low)) & ~mask;
        to_ = std::bit_cast<std::uint32_t>(static_cast<float>(high * high)) & ~mask;
    }

    double square(std::uint32_t index) const {
        const auto square = std::bit_cast<float>(index << shift_ | from_);
        return square < low_ * low_ ? std::bit_cast<float>(index << shift_ | to_) : square;
    }

private:
    double low_;
    int shift_ = 0;
    std::uint32_t from_ = 0, to_ = 0;
};

bool is_moderate(double value, double beside) { return std::isfinite(value) && std::abs(value) <= 1e6 * beside; }

}  // namespace

LammpsTable::LammpsTable(const ComposedPairs& force, const PairProperties<double>& pair, double nearest, double high)
    : potential_(force, 1), pair_(pair), nearest_(std::min(nearest, high / 2)) {
    const double low = nearest_ * 1e-6, force_there = low * force_over_distance(low * low);
    scale_ = 0;
    for (const double part : {0.9, 1.0, 1.1})
        scale_ = std::max(scale_, std::abs(force_over_distance(part * part * nearest_ * nearest_)));
    range_ = {is_moderate(force_there, neighbour_force()) ? low : nearest_ / 3, high};
}

void LammpsTable::divide(Kind kind, int bits) {
    kind_ = kind;
    squares_.resize(std::size_t{1} << bits);
    const double low2 = range_.low * range_.low, high2 = range_.high * range_.high;
    const Bitmap bitmap(range_.low, range_.high, bits);
    const double last = static_cast<double>(squares_.size() - 1);
    for (std::size_t i = 0; i < squares_.size(); ++i)
        squares_[i] = kind == Kind::bitmap ? bitmap.square(static_cast<std::uint32_t>(i))
                                           : low2 + (high2 - low2) * static_cast<double>(i) / last;
}

/// A line between two points, or a cubic through the four around, halfway between two points, whose error is larger
/// than that of a spline.
double LammpsTable::error() const {
    double largest = kind_ == Kind::bitmap ? rounding_of_floats : 0;
    std::vector<double> ascending = squares_, values;
    std::sort(ascending.begin(), ascending.end());
    for (const double square : ascending) values.push_back(force_over_distance(square));
    for (std::size_t i = 1; i + 2 < ascending.size(); ++i) {
        const double middle = (ascending[i] + ascending[i + 1]) / 2, inside = (values[i] + values[i + 1]) / 2;
        if (ascending[i + 1] > range_.high * range_.high) break;
        const double outside = (values[i - 1] + values[i + 2]) / 2;
        const double interpolated = kind_ == Kind::bitmap ? inside : (9 * inside - outside) / 8;
        const double exact = force_over_distance(middle);
        const double least = scale_ > 0 ? scale_ : std::numeric_limits<double>::min();
        largest = std::max(largest, std::abs(interpolated - exact) / std::max(std::abs(exact), least));
    }
    return largest;
}

void LammpsTable::write(OutputFile& file, const std::string& name) const {
    const bool bitmap = kind_ == Kind::bitmap;
    std::string text = fmt::format("{}\nN {} {} ", name, squares_.size(), bitmap ? "BITMAP" : "RSQ");
    append_number(text, range_.low);
    text += ' ';
    append_number(text, range_.high);
    text += "\n\n";
    for (std::size_t i = 0; i < squares_.size(); ++i) {
        // LAMMPS divides the force by a root taken in float.
        const double root =
            bitmap ? static_cast<double>(std::sqrt(static_cast<float>(squares_[i]))) : std::sqrt(squares_[i]);
        text += fmt::format("{} ", i + 1);
        for (const double number : {root, potential_.energy(squares_[i], pair_)}) {
            append_number(text, number);
            text += ' ';
        }
        append_number(text, root * force_over_distance(squares_[i]));
        text += '\n';
        if (text.size() < 1 << 16) continue;
        file.write(text);
        text.clear();
    }
    file.write(text + "\n");
}

LammpsTableSize size_for(std::vector<LammpsTable>& tables) {
    LammpsTableSize best{.error = std::numeric_limits<double>::infinity()};
    const auto attempt = [&](LammpsTable::Kind kind, int bits) {
        double error = 0;
        for (LammpsTable& table : tables) {
            table.divide(kind, bits);
            error = std::max(error, table.error());
        }
        if (error < best.error) best = {kind, bits, error};
    };
    for (int bits = fewest_bits; bits <= most_bits && !(best.error <= wanted_error); ++bits)
        attempt(LammpsTable::Kind::spline, bits);
    if (!(best.error <= rounding_of_floats)) attempt(LammpsTable::Kind::bitmap, bitmap_bits);
    for (LammpsTable& table : tables) table.divide(best.kind, best.bits);
    return best;
}

}  // namespace steplab
