#include "app/cli/standard_streams.hpp"

#include "core/shown.hpp"
#include "io/output_file.hpp"

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace steplab {

void print(std::string_view text) { print_data(safe_message(text)); }

void print_data(std::string_view text) {
    OutputFile out("-");
    out.write(text);
    out.commit();
}

void print_aside(std::string_view text) { print_aside({text}); }

void print_aside(std::initializer_list<std::string_view> parts) { write_safely(stderr, parts); }

void print_beside(std::string_view text, bool data_on_standard_output) {
    data_on_standard_output ? print_aside(text) : print(text);
}

void print_note(std::string_view program, std::string_view note) { print_aside({program, ": note: ", note, "\n"}); }

void prepare_standard_streams() {
    // A closed stream is opened for reading only, so that writing to it is an error; open() returns the lowest number.
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != descriptor) return;
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);  // exceeding a limit on file sizes then is a write error
}

}  // namespace steplab
