// Session files of any content: each is read or refused, and what is read is written as a text that reads as the same.

#include "session/session_file.hpp"

#include "core/error.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace steplab;
    try {
        const std::string text(reinterpret_cast<const char*>(data), size);
        const std::string once = session_text(parse_session(text, "a.session"));
        if (session_text(parse_session(once, "a.session")) != once) std::abort();
    } catch (const Error&) {  // all that may come out of it
    }
    return 0;
}
