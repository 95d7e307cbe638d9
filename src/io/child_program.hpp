#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace steplab {

/// Another program that was started, found through PATH. Its standard output is dropped, and its messages are kept
/// instead of being shown. It ends with this object at the latest, and is not reached by the keys that interrupt this
/// program.
///
///     ChildProgram ffmpeg({"ffmpeg", ...}, ChildProgram::Input::from_here);
///     if (ffmpeg.is_missing()) ...
///     while (more && ffmpeg.write(bytes)) ...
///     if (ffmpeg.end() != ChildProgram::End::done) throw FileError(ffmpeg.messages());
class ChildProgram {
public:
    /// What it reads from standard input: nothing, or what write() is given.
    enum class Input { nothing, from_here };
    enum class End {
        done,
        failed,   ///< with another exit code than 0, or by a signal
        missing,  ///< there is no such program, or it cannot be run
    };

    /// The name under which it finds the file that it is given.
    static constexpr const char* given_file = "/dev/fd/3";

    /// `file`: a descriptor of an open file, or -1.
    explicit ChildProgram(std::vector<std::string> arguments, Input input = Input::nothing, int file = -1);
    ~ChildProgram();
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    bool is_missing() const { return process_ < 0; }
    /// Hands it these bytes. False if it reads no more, as when it has ended. Throws Interrupted.
    bool write(std::string_view bytes);
    /// Ends its input and waits for its end. Throws Interrupted.
    End end();
    /// How it ended, if it has ended by now.
    std::optional<End> ended();
    /// Has it end on SIGTERM, so that it can end programs of its own; waits for it for this long at most, and then
    /// leaves it to itself.
    void ask_to_end(double seconds);
    /// What it wrote to standard error so far: the beginning of a long text, without the end of the last line.
    std::string messages() const;

private:
    void close_input();

    pid_t process_ = -1;  ///< 0 once it has ended
    End how_ = End::missing;
    int input_ = -1;
    int messages_ = -1;
};

}  // namespace steplab
