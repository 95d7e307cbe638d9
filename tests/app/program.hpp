#pragma once

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace steplab {

/// The environment of a program.
struct Surroundings {
    std::string program = "steplab";            ///< in build/<preset>/bin, or a path
    std::string folder = ".";                   ///< working folder
    std::vector<std::string> environment = {};  ///< "NAME=value", added to the test's own
    std::string standard_output = {};           ///< a file to open for it; empty: the test reads it
    bool standard_output_closed = false;
    std::optional<unsigned long> largest_file = {};  ///< bytes a file may have, as on a full disk
    std::optional<unsigned long> most_memory = {};   ///< bytes of address space (ulimit -v)
    bool no_threads = false;                         ///< none can be started, as at a limit of processes
};

/// The result of a program.
struct Outcome {
    int code = -1;   ///< exit code; -1 if a signal ended it
    int signal = 0;  ///< the signal that ended it, 0 if none did
    std::string out;
    std::string err;
    long kilobytes = 0;  ///< peak memory
};

/// A running program. Its standard output is a pipe to this object.
class RunningProgram {
public:
    explicit RunningProgram(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    /// Waits for more of the output; empty at its end.
    std::string read_some();
    /// Closes the reader of the output.
    void close_output();
    void send(int signal) const;
    /// Reads what is left and waits for the end.
    Outcome wait();

private:
    pid_t process_ = -1;
    int output_ = -1;
    int errors_ = -1;
    std::string read_;
};

/// Runs a program to its end.
Outcome run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

/// What a program wrote to standard error but for lines of progress ("steplab report: 48 %, 12 s left", "steplab
/// limits: measuring the limit of rk4"), of which a slow machine makes some.
std::string without_progress(const std::string& errors);

}  // namespace steplab
