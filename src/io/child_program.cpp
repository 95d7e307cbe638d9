#include "io/child_program.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

constexpr int milliseconds_of_waiting = 10;
constexpr int number_of_given_file = 3;

[[noreturn]] void fail(const std::string& program) {
    throw FileError(fmt::format("cannot start {}: {}", program, std::generic_category().message(errno)));
}

/// What the program gets for its standard streams, and how signals reach it.
class Setup {
public:
    /// `input`: to read from, or -1; `file`: for it to write, or -1.
    Setup(int input, int messages, int file) {
        posix_spawn_file_actions_init(&files_);
        if (input < 0) {
            posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        } else {
            posix_spawn_file_actions_adddup2(&files_, input, STDIN_FILENO);
        }
        posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&files_, messages, STDERR_FILENO);
        // Last: any of the others may have this number here.
        if (file >= 0) posix_spawn_file_actions_adddup2(&files_, file, number_of_given_file);
        posix_spawnattr_init(&attributes_);
        // In a group of its own it does not get Ctrl+C, on which it would end with an error or half a file; signals
        // that are ignored or wait here would do so there.
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
        posix_spawnattr_setpgroup(&attributes_, 0);
        sigset_t usual;
        sigemptyset(&usual);
        posix_spawnattr_setsigmask(&attributes_, &usual);
        for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, signal);
        posix_spawnattr_setsigdefault(&attributes_, &usual);
    }
    ~Setup() {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }
    Setup(const Setup&) = delete;
    Setup& operator=(const Setup&) = delete;

    /// The number of the new process; -1 if the program cannot be run.
    pid_t start(std::vector<std::string>& arguments) const {
        std::vector<char*> words;
        words.reserve(arguments.size() + 1);
        for (std::string& argument : arguments) words.push_back(argument.data());
        words.push_back(nullptr);
        pid_t process = -1;
        const int error = posix_spawnp(&process, words[0], &files_, &attributes_, words.data(), environ);
        return error == 0 ? process : -1;
    }

private:
    posix_spawn_file_actions_t files_;
    posix_spawnattr_t attributes_;
};

}  // namespace

ChildProgram::ChildProgram(std::vector<std::string> arguments, Input input, int file) {
    std::array<int, 2> ends{-1, -1};
    messages_ = memfd_create("messages", MFD_CLOEXEC);
    if (messages_ < 0) fail(arguments.front());
    if (input == Input::from_here && pipe2(ends.data(), O_CLOEXEC) != 0) {
        close(messages_);
        fail(arguments.front());
    }
    process_ = Setup(ends[0], messages_, file).start(arguments);
    if (input == Input::nothing) return;
    close(ends[0]);
    input_ = ends[1];
    fcntl(input_, F_SETFL, O_NONBLOCK);  // so that a signal is answered while the program does not read
}

ChildProgram::~ChildProgram() {
    if (process_ > 0) {
        kill(-process_, SIGKILL);  // and what it has started in its group
        waitpid(process_, nullptr, 0);
    }
    close_input();
    close(messages_);
}

bool ChildProgram::write(std::string_view bytes) {
    while (!bytes.empty()) {
        check_interruption();
        const ssize_t written = ::write(input_, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EAGAIN) {
            pollfd place{input_, POLLOUT, 0};
            poll(&place, 1, milliseconds_of_waiting);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

ChildProgram::End ChildProgram::end() {
    close_input();
    std::optional<End> how;
    while (!(how = ended())) {
        check_interruption();
        poll(nullptr, 0, milliseconds_of_waiting);
    }
    return *how;
}

std::optional<ChildProgram::End> ChildProgram::ended() {
    if (process_ <= 0) return how_;
    int status = 0;
    const pid_t ended = waitpid(process_, &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
    process_ = 0;
    constexpr int of_shells = 127;  // a script that starts what is missing
    const bool failed = ended < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0;
    const bool missing = failed && ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == of_shells;
    how_ = missing ? End::missing : failed ? End::failed : End::done;
    return how_;
}

void ChildProgram::ask_to_end(double seconds) {
    if (process_ <= 0) return;
    kill(-process_, SIGTERM);
    const int times = static_cast<int>(seconds * 1000) / milliseconds_of_waiting;
    for (int i = 0; i < times && !ended(); ++i) poll(nullptr, 0, milliseconds_of_waiting);
    process_ = 0;
}

std::string ChildProgram::messages() const {
    std::array<char, 2000> text;
    const ssize_t got = pread(messages_, text.data(), text.size(), 0);
    std::string message(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    while (message.ends_with('\n')) message.pop_back();
    return message;
}

void ChildProgram::close_input() {
    if (input_ >= 0) close(std::exchange(input_, -1));
}

}  // namespace steplab
