#include "app/program.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <regex>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace steplab {

namespace {

constexpr int failed_before_start = 127;

std::string path_of(const std::string& program) {
    return program.find('/') == std::string::npos ? std::string(STEPLAB_BINARY_DIR) + "/bin/" + program : program;
}

void limit(int resource, rlim_t most) {
    const rlimit both{most, most};
    if (setrlimit(resource, &both) != 0) _exit(failed_before_start);
}

/// In the child: sets up the environment, then becomes the program.
[[noreturn]] void become(const std::vector<std::string>& arguments, const Surroundings& surroundings, int out,
                         int err) {
    const std::string program = path_of(surroundings.program);
    if (!surroundings.standard_output.empty())
        out = open(surroundings.standard_output.c_str(), O_WRONLY | O_CREAT, 0600);
    if (out < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(err, STDERR_FILENO) < 0) _exit(failed_before_start);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);  // as from a terminal
    if (surroundings.standard_output_closed) close(STDOUT_FILENO);
    if (chdir(surroundings.folder.c_str()) != 0) _exit(failed_before_start);
    for (const std::string& setting : surroundings.environment) putenv(const_cast<char*>(setting.c_str()));
    if (surroundings.largest_file) limit(RLIMIT_FSIZE, *surroundings.largest_file);
    if (surroundings.most_memory) limit(RLIMIT_AS, *surroundings.most_memory);
    // A thread's stack has the size of this limit, for which no machine has the memory.
    if (surroundings.no_threads) limit(RLIMIT_STACK, 1UL << 50);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    _exit(failed_before_start);
}

std::string contents(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer;
    lseek(descriptor, 0, SEEK_SET);
    for (ssize_t n = 0; (n = read(descriptor, buffer.data(), buffer.size())) > 0;) {
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
    return text;
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    std::array<int, 2> pipe_ends{-1, -1};
    errors_ = memfd_create("errors", MFD_CLOEXEC);
    if (errors_ < 0 || pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a program");
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no process for a program");
    if (process_ == 0) become(arguments, surroundings, pipe_ends[1], errors_);
    close(pipe_ends[1]);
    output_ = pipe_ends[0];
}

RunningProgram::~RunningProgram() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    close_output();
    close(errors_);
}

std::string RunningProgram::read_some() {
    std::array<char, 65536> buffer;
    const ssize_t n = output_ < 0 ? 0 : read(output_, buffer.data(), buffer.size());
    std::string some(buffer.data(), n > 0 ? static_cast<std::size_t>(n) : 0);
    read_ += some;
    return some;
}

void RunningProgram::close_output() {
    if (output_ >= 0) close(output_);
    output_ = -1;
}

void RunningProgram::send(int signal) const { kill(process_, signal); }

Outcome RunningProgram::wait() {
    while (!read_some().empty()) {
    }
    int status = 0;
    rusage usage{};
    wait4(process_, &status, 0, &usage);
    process_ = -1;
    Outcome outcome{.out = read_, .err = contents(errors_), .kilobytes = usage.ru_maxrss};
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    return outcome;
}

Outcome run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    return RunningProgram(arguments, surroundings).wait();
}

std::string without_progress(const std::string& errors) {
    static const std::regex line(
        "steplab (report|advise|limits): ([0-9]+ %(, .* left)?|(computing|finding|measuring) .*)\\n");
    return std::regex_replace(errors, line, "");
}

}  // namespace steplab
