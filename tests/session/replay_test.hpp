#pragma once

#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "session/replayed.hpp"
#include "session/session_file.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <string>

namespace steplab::test {

/// The same of the recording as a file has it, which has to have it without loss.
inline std::string replayed_from_text(const Recording& recording) {
    const std::string text = session_text(recording);
    const Recording read = parse_session(text, "a.session");
    EXPECT_EQ(session_text(read), text);
    EXPECT_EQ(read.start, recording.start);
    EXPECT_EQ(read.events.size(), recording.events.size());
    return replayed(read);
}

/// Nothing that a file holds ends in a crash: it is refused, or something else is computed.
inline void expect_answer(const std::string& text) {
    try {
        replayed(parse_session(text, "a.session"));
    } catch (const FileError&) {
    } catch (const UsageError&) {
    }
}

inline RunDescription replayed_chain(Precision precision = Precision::double_) {
    return run_of("chain", "verlet", precision, 0.1);
}

inline constexpr const char* scene_text =
    "steplab = 1\ntitle = \"of a file\"  # \\ and \"\"\" in it\r\n[parameters]\nG = 1.5\n[[particles]]\nfile = "
    "\"a.xyz\"\n"
    "[[pairs]]\npotential = \"gravity\"\nG = \"G\"\nsoftening = 0.1\n";
inline constexpr const char* particles_text =
    "3\nProperties=species:S:1:pos:R:3:velo:R:3 Time=0 Step=0\nX 0 0 0 0 0 0\nX 1 0 0 0 1 0\nX -2 0 0.5 0 -1 0\n";

inline RunDescription of_scene_file() {
    return describe(scene_from({{.name = "", .content = scene_text}, {.name = "a.xyz", .content = particles_text}},
                               "folder/a.toml"));
}

}  // namespace steplab::test
