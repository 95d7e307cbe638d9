// LAMMPS dumps of any content: from front to back and by their index; what is read is written as a dump that reads as
// the same.

#include "core/error.hpp"
#include "fuzz/memory_file.hpp"
#include "io/dump_text.hpp"
#include "io/indexed_text.hpp"
#include "io/text_trajectory.hpp"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

namespace steplab {
namespace {

std::unique_ptr<TextTrajectory> opened(const std::string& text) {
    return TextTrajectory::open(TextInput("a.dump", std::make_shared<const std::string>(text)),
                                TextTrajectory::From::any_program);
}

void read(const std::string& text) {
    const auto dump = opened("ITEM:" + text);
    for (FrameBlock frame, again; dump->next(frame);) {
        std::string once;
        append_dump(once, frame);
        if (!opened(once)->next(again) || again.positions != frame.positions) std::abort();
    }
}

void look_through(const std::string& name) {
    IndexedText frames(name);
    while (frames.has_more()) frames.look_on(1000);
    Frame frame;
    for (std::uint64_t number = 0; number < frames.frames(); ++number) frames.frame(number, frame);
}

/// Anything else than an Error is a mistake.
template <class Work>
void attempt(const Work& work) {
    try {
        work();
    } catch (const Error&) {
    }
}

}  // namespace
}  // namespace steplab

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace steplab;
    const std::string text(reinterpret_cast<const char*>(data), size);
    attempt([&] { read(text); });
    static const MemoryFile file;
    file.put("ITEM:" + text);
    attempt([&] { look_through(file.name()); });
    return 0;
}
