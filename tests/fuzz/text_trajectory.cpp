#include "io/text_trajectory.hpp"

#include "core/error.hpp"
#include "fuzz/memory_file.hpp"
#include "io/trajectory_text.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab {
namespace {

void read(const std::string& name) {
    const auto file = TextTrajectory::open(InputFile(name));
    std::string text;
    for (FrameBlock frame; file->next(frame);) {
        text.clear();
        append_csv(text, frame, file->columns());
        append_xyz(text, frame, {});
    }
}

}  // namespace
}  // namespace steplab

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const steplab::MemoryFile file;
    file.put({reinterpret_cast<const char*>(data), size});
    try {
        steplab::read(file.name());
    } catch (const steplab::Error&) {  // all that may come out of it
    }
    return 0;
}
