#include "io/trajectory_chunk.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <type_traits>
#include <zstd.h>

namespace steplab::trajectory {

namespace {

/// zstd's fastest regular level; a higher one does not make random digits smaller.
constexpr int compression_level = 1;
constexpr std::size_t components = 6;

template <class Number>
using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;

/// Writes numbers so that all lowest bytes come first, then all second ones, and so on.
template <class Integer>
class ByBytes {
public:
    /// For `count` numbers at the end of `bytes`, which must not grow meanwhile.
    ByBytes(std::string& bytes, std::size_t count) : count_(count) {
        bytes.resize(bytes.size() + count * sizeof(Integer));
        out_ = bytes.data() + bytes.size() - count * sizeof(Integer);
    }
    void add(Integer value) {
        held_back_[held_] = value;
        if (++held_ == held_back_.size()) flush();
    }
    void flush() {
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            for (std::size_t j = 0; j < held_; ++j)
                out_[i * count_ + j] = static_cast<char>(held_back_[j] >> (8 * i) & 0xff);
        }
        out_ += held_;
        held_ = 0;
    }

private:
    char* out_ = nullptr;
    std::size_t count_;
    std::array<Integer, 512> held_back_;  // split at once, in vector registers
    std::size_t held_ = 0;
};

/// The reverse, from the front of bytes that are known to be enough.
template <class Integer>
std::vector<Integer> take_by_bytes(std::string_view& bytes, std::size_t count) {
    std::vector<Integer> values(count);
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            const auto byte = static_cast<unsigned char>(bytes[i * count + j]);
            values[j] |= static_cast<Integer>(static_cast<Integer>(byte) << (8 * i));
        }
    }
    bytes.remove_prefix(count * sizeof(Integer));
    return values;
}

/// Calls visit(place, number) for each number of the block in the order of the file.
template <class Block, class Visit>
void visit_numbers(Block& block, Version version, const Visit& visit) {
    std::size_t place = 0;
    auto& where = version == Version::positions ? block.positions : block.displacements;
    for (auto* vectors : {&where, &block.velocities}) {
        for (const auto component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            for (std::size_t row = 0; row < block.rows; ++row) {
                for (std::size_t moment = 0; moment < block.moments.size(); ++moment)
                    visit(place++, (*vectors)[moment * block.rows + row].*component);
            }
        }
    }
}

template <class Number>
void append_numbers(std::string& bytes, const FrameBlock& block, Version version) {
    ByBytes<Bits<Number>> numbers(bytes, block.all_rows() * components);
    visit_numbers(block, version, [&](std::size_t, double number) {
        numbers.add(std::bit_cast<Bits<Number>>(static_cast<Number>(number)));
    });
    numbers.flush();
}

void append_moments(std::string& bytes, const FrameBlock& block) {
    ByBytes<std::uint64_t> numbers(bytes, 2 * block.moments.size());
    for (const FrameBlock::Moment& moment : block.moments) numbers.add(moment.step);
    for (const FrameBlock::Moment& moment : block.moments) numbers.add(std::bit_cast<std::uint64_t>(moment.time));
    numbers.flush();
}

template <class Number>
void take_numbers(std::string_view& bytes, FrameBlock& block, Version version) {
    const auto values = take_by_bytes<Bits<Number>>(bytes, block.all_rows() * components);
    visit_numbers(block, version, [&](std::size_t place, double& number) {
        number = static_cast<double>(std::bit_cast<Number>(values[place]));
    });
}

}  // namespace

void append_chunk(std::string& bytes, std::string& scratch, const FrameBlock& block, Version version) {
    scratch.clear();
    append_moments(scratch, block);
    if (block.scene.precision == Precision::float_) {
        append_numbers<float>(scratch, block, version);
    } else {
        append_numbers<double>(scratch, block, version);
    }
    BlockHead head;
    head.frames = static_cast<std::uint32_t>(block.moments.size());
    head.first_frame = block.first_frame;
    head.first_row = block.first_row;
    head.rows = block.rows;
    const std::size_t begin = bytes.size() + BlockHead::bytes;
    bytes.resize(begin + ZSTD_compressBound(scratch.size()));
    const std::size_t size =
        ZSTD_compress(bytes.data() + begin, bytes.size() - begin, scratch.data(), scratch.size(), compression_level);
    if (ZSTD_isError(size))
        throw FileError(fmt::format("cannot compress frame {}: {}", block.first_frame, ZSTD_getErrorName(size)));
    bytes.resize(begin + size);
    bytes.replace(begin - BlockHead::bytes, BlockHead::bytes, head_bytes(head, std::string_view(bytes).substr(begin)));
}

std::size_t most_content_bytes() {
    return ZSTD_compressBound(most_rows * (2 * sizeof(std::uint64_t) + components * sizeof(double)));
}

std::optional<FrameBlock> parse_chunk(const BlockHead& head, std::string_view content, Precision precision,
                                      Version version) {
    if (head.frames == 0 || head.rows == 0 || head.rows > most_rows || head.frames > most_rows / head.rows)
        return std::nullopt;
    const std::size_t rows = head.frames * head.rows;
    const std::size_t number = precision == Precision::float_ ? sizeof(float) : sizeof(double);
    std::string large(2 * sizeof(std::uint64_t) * head.frames + components * number * rows, '\0');
    const std::size_t size = ZSTD_decompress(large.data(), large.size(), content.data(), content.size());
    if (ZSTD_isError(size) || size != large.size()) return std::nullopt;
    std::string_view bytes = large;
    const auto moments = take_by_bytes<std::uint64_t>(bytes, 2 * head.frames);
    FrameBlock block;
    block.scene.precision = precision;
    block.first_frame = head.first_frame;
    block.first_row = head.first_row;
    block.rows = head.rows;
    for (std::size_t i = 0; i < head.frames; ++i)
        block.moments.push_back({moments[i], std::bit_cast<double>(moments[head.frames + i])});
    (version == Version::positions ? block.positions : block.displacements).resize(rows);
    block.velocities.resize(rows);
    if (precision == Precision::float_) {
        take_numbers<float>(bytes, block, version);
    } else {
        take_numbers<double>(bytes, block, version);
    }
    return block;
}

}  // namespace steplab::trajectory
