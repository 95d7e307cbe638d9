#include "app/cli/command_line.hpp"

#include "app/cli/standard_streams.hpp"
#include "app/cli/text_table.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/output_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace steplab {

namespace {

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

[[noreturn]] void refuse_extra(const CLI::App& app, const std::string& word) {
    if (!word.starts_with('-'))
        throw UsageError(fmt::format("unexpected argument '{}': values follow the name of an option", shown(word)));
    const std::vector<std::string> names = option_names(app);
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UsageError(unknown_word("option", word.substr(0, word.find('=')), known));
}

/// Turns the parser's "--dt: At Most 1 required but received 2" and the like into plain messages.
[[noreturn]] void refuse_count(const CLI::ArgumentMismatch& error) {
    const std::string text = error.what();
    const std::string option = text.substr(0, text.find(':'));
    const bool too_many = text.find("At Most") != std::string::npos;
    throw UsageError(option + (too_many ? " is given more than once" : " needs a value"));
}

/// The parser would read the argument after "--out=" as its value.
void refuse_empty_values(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
        if (argument.starts_with("--") && argument.find('=') == argument.size() - 1) {
            throw UsageError(fmt::format("{} needs a value", shown(argument.substr(0, argument.size() - 1))));
        }
    }
}

/// No option accepts an empty value.
void refuse_empty_values(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& value : option->results()) {
            if (value.empty()) throw UsageError(fmt::format("{} needs a value", option->get_name()));
        }
    }
}

/// Without the parser's double empty lines, and those at the end.
std::string tidy(std::string text) {
    for (auto gap = text.find("\n\n\n"); gap != std::string::npos; gap = text.find("\n\n\n")) text.erase(gap, 1);
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

void in_group(CLI::Option* option, const std::string& group) {
    if (!group.empty()) option->group(group);
}

/// Column of the help at which the descriptions of options begin.
constexpr std::size_t help_column = 32;

/// The parser indents each line.
std::string help_text(const std::string& what) {
    return fmt::format("{}", fmt::join(wrapped_lines(what, page_width - help_column), "\n"));
}

/// A line on standard error, which needs no memory.
int failed(const std::string& program, ExitCode code, const char* message, const char* reason = "") {
    print_aside({program, ": ", message, reason, "\n"});
    return static_cast<int>(code);
}

}  // namespace

void text_option(CLI::App& app, const std::string& name, std::string& value, const std::string& placeholder,
                 const std::string& what, const std::string& group) {
    const auto take = [&value](const CLI::results_t& results) {
        value = results.back();
        return true;
    };
    in_group(app.add_option(name, take, help_text(what))->option_text(placeholder), group);
}

void optional_text_option(CLI::App& app, const std::string& name, std::string& value, const std::string& placeholder,
                          const std::string& without, const std::string& what, const std::string& group) {
    const auto take = [&value](const CLI::results_t& results) {
        value = results.back();
        return true;
    };
    in_group(
        app.add_option(name, take, help_text(what))->option_text(placeholder)->expected(0, 1)->default_str(without),
        group);
}

void repeated_option(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                     const std::string& placeholder, const std::string& what, const std::string& group) {
    const auto take = [&values](const CLI::results_t& results) {
        values = results;
        return true;
    };
    in_group(app.add_option(name, take, help_text(what))
                 ->option_text(placeholder)
                 ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll),
             group);
}

void flag_option(CLI::App& app, const std::string& name, bool& value, const std::string& what,
                 const std::string& group) {
    in_group(app.add_flag(name, value, help_text(what)), group);
}

void footer(CLI::App& app, std::function<std::string()> text) { app.footer(std::move(text)); }

std::uint64_t whole_number(std::string_view option, const std::string& text, double maximum, std::string_view what) {
    const ParameterInfo info{.name = option,
                             .kind = ParameterInfo::Kind::integer,
                             .unit = "",
                             .minimum = 1,
                             .maximum = maximum,
                             .what = what};
    return static_cast<std::uint64_t>(parse_value(info, text));
}

bool is_given(const CLI::App& app, const std::string& name) { return app.count(name) > 0; }

std::optional<std::string> parse(CLI::App& app, std::vector<std::string> arguments) {
    refuse_empty_values(arguments);
    app.allow_extras();
    app.get_formatter()->column_width(help_column);
    std::reverse(arguments.begin(), arguments.end());  // the order that the parser expects
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        return tidy(app.help());
    } catch (const CLI::CallForVersion& version) {
        return std::string(version.what()) + "\n";
    } catch (const CLI::ArgumentMismatch& error) {
        refuse_count(error);
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    refuse_empty_values(app);
    const std::vector<std::string> extras = app.remaining();
    if (!extras.empty()) refuse_extra(app, extras.front());
    return std::nullopt;
}

int guarded(const std::string& program, const std::function<int()>& body) {
    try {
        return body();
    } catch (const Error& error) {
        return failed(program, error.code(), error.what());
    } catch (const ReaderGone&) {
        return static_cast<int>(ExitCode::done);
    } catch (const Interrupted& interrupted) {
        return interrupted.exit_code();
    } catch (const std::bad_alloc&) {
        return failed(program, ExitCode::usage, "not enough memory");
    } catch (const std::length_error&) {
        return failed(program, ExitCode::usage, "not enough memory: more than any array can hold");
    } catch (const std::filesystem::filesystem_error& error) {
        return failed(program, ExitCode::file, error.what());
    } catch (const std::system_error& error) {
        return failed(program, ExitCode::usage, "the system grants no more threads or memory: ", error.what());
    } catch (const std::exception& error) {
        return failed(program, ExitCode::usage, error.what());
    }
}

}  // namespace steplab
