#include "io/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {
namespace {

constexpr std::size_t most_parts = 100;  // of a key: a.b.c has three

/// Goes through a text once, over strings and comments, before it is parsed.
class Look {
public:
    Look(std::string_view text, std::size_t most_values) : text_(text), most_values_(most_values) {}

    void check() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                skip_string(c);
            } else if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else {
                read(c);
                ++at_;
            }
        }
    }

private:
    void read(char c) {
        if (c == '\n') {
            ++line_;
            line_start_ = at_ + 1;
        }
        if (c == '.') {
            if (++parts_ > most_parts) fail(fmt::format("a key has at most {} parts", most_parts));
        } else if (c == '=' || c == ',' || c == '\n' || c == '[' || c == ']' || c == '{' || c == '}') {
            parts_ = 1;
        }
        if ((c == '=' || c == ',') && ++values_ > most_values_)
            fail(fmt::format("there are more than {} values; large scenes read their particles from a file",
                             most_values_));
    }

    void skip_string(char quote) {
        const std::string three(3, quote);
        const bool multiline = text_.substr(at_, 3) == three;
        at_ += multiline ? 3 : 1;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\n') {
                if (!multiline) return;  // it has no end: what comes is for the parser to refuse
                ++line_;
                line_start_ = at_ + 1;
            }
            if (c == '\\' && quote == '"') {
                at_ += text_.substr(at_ + 1, 1) == "\n" ? 1 : 2;  // the end of a line counts
            } else if (multiline ? text_.substr(at_, 3) == three : c == quote) {
                at_ += multiline ? 3 : 1;
                return;
            } else {
                ++at_;
            }
        }
    }

    [[noreturn]] void fail(const std::string& message) const {
        const toml::source_position place{line_, static_cast<toml::source_index>(at_ - line_start_ + 1)};
        throw toml::parse_error(message.c_str(), place);
    }

    std::string_view text_;
    std::size_t most_values_;
    std::size_t at_ = 0, line_start_ = 0, parts_ = 1, values_ = 0;
    toml::source_index line_ = 1;
};

}  // namespace

toml::table toml_table(std::string_view text, const std::string& name, std::size_t most_values) {
    Look(text, most_values).check();
    return toml::parse(text, name);
}

}  // namespace steplab
