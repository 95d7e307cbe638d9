#include "core/error.hpp"
#include "fuzz/memory_file.hpp"
#include "io/trajectory_chunk.hpp"
#include "io/trajectory_reader.hpp"
#include "io/trajectory_text.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace steplab {
namespace {

using namespace trajectory;

void put(std::string& bytes, std::size_t place, std::uint64_t value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes[place + i] = static_cast<char>(value >> (8 * i) & 0xff);
}

std::uint64_t number_at(const std::string& bytes, std::size_t place) {
    std::uint64_t value = 0;
    for (std::size_t i = sizeof value; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[place + i]);
    return value;
}

/// The bytes with the hashes that a forger would put there: else hardly an input would pass the first of them.
std::string with_right_hashes(std::string bytes) {
    for (std::size_t place = signature_bytes; place + BlockHead::bytes <= bytes.size();) {
        const std::size_t begin = place + BlockHead::bytes, left = bytes.size() - begin;
        const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(number_at(bytes, place + 32), left));
        put(bytes, place + 40, hash_of(std::string_view(bytes).substr(begin, size)));
        put(bytes, place + 48, hash_of(std::string_view(bytes).substr(place, 48)));
        place = begin + size;
    }
    return bytes;
}

void read(const std::string& name) {
    TrajectoryReader reader((InputFile(name)));
    const Columns columns = reader.version() == Version::positions ? usual_columns() : parse_columns("x,y,z,ux,uy,uz");
    reader.require(columns);
    std::string text, scratch;
    reader.each_block([&](const FrameBlock& block) {
        text.clear();
        append_csv(text, block, columns);
        append_xyz(text, block, columns);
        append_chunk(text, scratch, block, reader.version());
    });
    Frame frame;
    reader.frame(reader.frames() / 2, frame);
    static_cast<void>(reader.run());
}

}  // namespace
}  // namespace steplab

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const steplab::MemoryFile file;
    file.put(steplab::with_right_hashes(std::string(data, data + size)));
    try {
        steplab::read(file.name());
    } catch (const steplab::Error&) {  // all that may come out of it
    }
    return 0;
}
