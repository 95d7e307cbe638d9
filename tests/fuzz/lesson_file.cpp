// Lesson files of any content, beside one session: each is read or refused.

#include "core/error.hpp"
#include "session/lesson.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace steplab;
    static const Recording session{.start = describe("chain"),
                                   .events = {{event::Step{10}, 0}, {event::Do{Kick{3, {0.5, 0, 0}}}, 10}},
                                   .end = RecordedEnd{20}};
    try {
        parse_lesson(std::string(reinterpret_cast<const char*>(data), size), "a.toml", session);
    } catch (const Error&) {  // all that may come out of it
    }
    return 0;
}
