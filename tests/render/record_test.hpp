#pragma once

#include "app/program.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

using Words = std::vector<std::string>;

inline Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// `steplab record` from outside, in an empty working folder.
class Record : public testing::Test {
protected:
    Outcome record(const Words& arguments, Words environment = {}) const {
        return run_program(joined({"record"}, arguments), {.folder = path(), .environment = std::move(environment)});
    }
    Outcome snapshot(const Words& arguments) const {
        return run_program(joined({"snapshot"}, arguments), {.folder = path()});
    }
    std::string path() const { return folder_.path(); }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::string bytes(const std::string& name) const { return text_of(folder_.file(name)); }
    bool nothing_written() const { return folder_.empty(); }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(path()), std::filesystem::directory_iterator()));
    }

    /// What a program prints that is not ours.
    std::string printed(const std::string& program, const Words& arguments) const {
        const Outcome outcome = run_program(arguments, {.program = program, .folder = path()});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    }
    /// "codec,width,height,pixel format,frames" of a film.
    std::string content(const std::string& film) const {
        return printed("/usr/bin/ffprobe",
                       {"-v", "error", "-count_frames", "-show_entries",
                        "stream=codec_name,width,height,pix_fmt,nb_read_frames", "-of", "csv=p=0", film});
    }
    double seconds(const std::string& film) const {
        return std::stod(printed("/usr/bin/ffprobe", {"-v", "error", "-show_entries", "format=duration", "-of",
                                                      "default=noprint_wrappers=1:nokey=1", film}));
    }

    /// A program called ffmpeg that does what the script says, and an environment in which it is found.
    Words with_ffmpeg(const std::string& script) const {
        const std::string place = programs_.file("ffmpeg");
        std::ofstream(place) << "#!/bin/sh\n" << script;
        std::filesystem::permissions(place, std::filesystem::perms::owner_all);
        return {"PATH=" + programs_.path() + ":/usr/bin:/bin"};
    }

private:
    TemporaryFolder folder_, programs_;
};

}  // namespace steplab
