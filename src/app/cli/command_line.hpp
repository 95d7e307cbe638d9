#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace steplab {

// Options are declared by these functions alone: the parser's own header, which is slow to compile, stays out of the
// commands.

/// Declares an option whose value is stored as text, to be read by our own parsers: in the C locale, with our messages.
/// `placeholder` stands for the value in the help: "--dt X". Options of one group are listed under its heading.
void text_option(CLI::App& app, const std::string& name, std::string& value, const std::string& placeholder,
                 const std::string& what, const std::string& group = "");
/// The same for an option whose value may be left out, which then is `without`.
void optional_text_option(CLI::App& app, const std::string& name, std::string& value, const std::string& placeholder,
                          const std::string& without, const std::string& what, const std::string& group = "");
/// The same for an option that may be repeated.
void repeated_option(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                     const std::string& placeholder, const std::string& what, const std::string& group = "");
/// An option without a value.
void flag_option(CLI::App& app, const std::string& name, bool& value, const std::string& what,
                 const std::string& group = "");
/// A whole number from 1 to `maximum`, the value of an option. Throws UsageError, which says `what` belongs there.
std::uint64_t whole_number(std::string_view option, const std::string& text, double maximum, std::string_view what);
/// True if the option, declared before, was on the command line that was parsed.
bool is_given(const CLI::App& app, const std::string& name);
/// Text at the end of the help, made when the help is printed.
void footer(CLI::App& app, std::function<std::string()> text);

/// Parses the arguments of one command, without its name. Returns the text to print instead of running the command if
/// --help or --version is among them. Throws UsageError: one line, with the nearest and the known options.
///
///     CLI::App app("what it does", "steplab-view");
///     options.declare(app);
///     if (const auto text = parse(app, arguments)) return print(*text);
std::optional<std::string> parse(CLI::App& app, std::vector<std::string> arguments);

/// Runs the body of a main. Any exception becomes one line on standard error, "program: message", and its exit code.
int guarded(const std::string& program, const std::function<int()>& body);

}  // namespace steplab
