#include "io/text_trajectory.hpp"

#include "core/error.hpp"
#include "fuzz/memory_file.hpp"
#include "io/trajectory_text.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab {
namespace {

bool fit_xyz(const Columns& columns) {
    try {
        check_xyz_columns(columns);
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

void read(const std::string& name) {
    const auto file = TextTrajectory::open(InputFile(name));
    std::string text;
    const bool xyz = fit_xyz(file->columns());
    for (FrameBlock frame; file->next(frame);) {
        text.clear();
        append_csv(text, frame, file->columns());
        if (xyz) append_xyz(text, frame, file->columns());
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
