// What the programs write to standard output and standard error. No other source of theirs does.
#pragma once

#include <initializer_list>
#include <string_view>

namespace steplab {

/// Text for people on standard output: control characters, which names and files may hold, reach no terminal
/// (safe_message()). Throws FileError or ReaderGone unless all of it is written.
void print(std::string_view text);
/// Data for programs on standard output, such as JSON: byte for byte. Throws as print() does.
void print_data(std::string_view text);

/// Text for people on standard error, where standard output has the data; safe as that of print(). Lost if standard
/// error is closed.
void print_aside(std::string_view text);
/// The same of a text in parts, without memory of its own, of which there may be none.
void print_aside(std::initializer_list<std::string_view> parts);
/// Text for people: beside the data if standard output has it (print_aside()), else there (print()).
void print_beside(std::string_view text, bool data_on_standard_output);
/// "steplab run: note: ...": a line of that.
void print_note(std::string_view program, std::string_view note);

/// Opens standard input, output and error where they are closed, so that no file gets their numbers, and turns a write
/// to a closed pipe into an error instead of a signal. To be called first in a main.
void prepare_standard_streams();

}  // namespace steplab
