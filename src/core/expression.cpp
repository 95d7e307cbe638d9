#include "core/expression.hpp"

#include "core/elementary.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace steplab {

namespace {

using Operation = Expression::Operation;
using Node = Expression::Node;

constexpr std::string_view blanks = " \t\n\r";

struct Function {
    std::string_view name;
    Operation operation;
    int arguments = 1;
};
constexpr std::array functions{
    Function{"exp", Operation::exp},    Function{"log", Operation::log}, Function{"sqrt", Operation::sqrt},
    Function{"sin", Operation::sin},    Function{"cos", Operation::cos}, Function{"tan", Operation::tan},
    Function{"tanh", Operation::tanh},  Function{"abs", Operation::abs}, Function{"min", Operation::min, 2},
    Function{"max", Operation::max, 2},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// By recursive descent.
class Parser {
public:
    Parser(std::string_view text, std::vector<Node>& nodes, std::vector<std::string>& names)
        : text_(text), nodes_(nodes), names_(names) {}

    void whole() {
        sum();
        skip_blanks();
        if (place_ < text_.size()) fail_here("expected an operator or the end");
    }

private:
    /// Brackets, signs and powers in each other; each takes some of the stack.
    static constexpr int deepest = 200;
    static constexpr std::size_t most_nodes = 10000;

    class Level {
    public:
        explicit Level(Parser& parser) : parser_(parser) {
            if (++parser_.depth_ > deepest)
                parser_.fail_here(fmt::format("brackets and signs are nested more than {} deep", deepest));
        }
        ~Level() { --parser_.depth_; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        Parser& parser_;
    };

    std::uint32_t sum() {
        std::uint32_t value = product();
        while (true) {
            if (takes('+')) {
                value = node(Operation::add, value, product());
            } else if (takes('-')) {
                value = node(Operation::subtract, value, product());
            } else {
                return value;
            }
        }
    }

    std::uint32_t product() {
        std::uint32_t value = signed_power();
        while (true) {
            if (takes('*')) {
                value = node(Operation::multiply, value, signed_power());
            } else if (takes('/')) {
                value = node(Operation::divide, value, signed_power());
            } else {
                return value;
            }
        }
    }

    std::uint32_t signed_power() {
        const Level level(*this);
        return takes('-') ? node(Operation::negate, signed_power()) : power();
    }

    std::uint32_t power() {
        const std::uint32_t base = atom();
        return takes('^') ? node(Operation::power, base, signed_power()) : base;
    }

    std::uint32_t atom() {
        skip_blanks();
        if (place_ == text_.size()) fail_here("ends where a number, a name or a bracket is expected");
        const char c = text_[place_];
        if (is_digit(c) || c == '.') return number();
        if (is_letter(c)) return name_or_function();
        if (!takes('(')) fail_here("expected a number, a name or a bracket");
        const std::uint32_t value = sum();
        expect(')');
        return value;
    }

    std::uint32_t number() {
        double value = 0;
        const char* const begin = text_.data() + place_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc{} || !std::isfinite(value)) fail_here("is no number that a double holds");
        place_ += static_cast<std::size_t>(end - begin);
        if (place_ < text_.size() && is_letter(text_[place_])) fail_here("expected an operator behind a number");
        return constant(value);
    }

    std::uint32_t name_or_function() {
        const std::size_t begin = place_;
        while (place_ < text_.size() && (is_letter(text_[place_]) || is_digit(text_[place_]))) ++place_;
        const std::string_view word = text_.substr(begin, place_ - begin);
        if (takes('(')) return call(word, begin);
        if (word == "pi") return constant(std::numbers::pi);
        const auto known = std::find(names_.begin(), names_.end(), word);
        const auto index = static_cast<std::uint32_t>(known - names_.begin());
        if (known == names_.end()) names_.emplace_back(word);
        return node(Operation::name, index);
    }

    std::uint32_t call(std::string_view word, std::size_t begin) {
        const auto known = std::find_if(functions.begin(), functions.end(),
                                        [word](const Function& function) { return function.name == word; });
        if (known == functions.end()) {
            std::array<std::string_view, functions.size()> names;
            std::transform(functions.begin(), functions.end(), names.begin(), [](const auto& f) { return f.name; });
            throw ExpressionError(begin, unknown_word("function", word, names));
        }
        const Level level(*this);
        const std::uint32_t first = sum();
        if (known->arguments == 2) expect(',');
        const std::uint32_t second = known->arguments == 2 ? sum() : 0;
        expect(')');
        return node(known->operation, first, second);
    }

    std::uint32_t constant(double value) {
        const std::uint32_t place = node(Operation::number);
        nodes_.back().number = value;
        return place;
    }

    std::uint32_t node(Operation operation, std::uint32_t first = 0, std::uint32_t second = 0) {
        if (nodes_.size() == most_nodes)
            fail_here(fmt::format("has more than {} numbers, names and operations", most_nodes));
        nodes_.push_back({operation, first, second});
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }

    void skip_blanks() { place_ = std::min(text_.find_first_not_of(blanks, place_), text_.size()); }
    bool takes(char c) {
        skip_blanks();
        if (place_ == text_.size() || text_[place_] != c) return false;
        ++place_;
        return true;
    }
    void expect(char c) {
        if (!takes(c)) fail_here(fmt::format("expected '{}'", c));
    }
    [[noreturn]] void fail_here(const std::string& what) {
        skip_blanks();
        const std::string_view rest = text_.substr(place_, 20);
        throw ExpressionError(place_, rest.empty() ? what : fmt::format("{} at \"{}\"", what, shown(rest)));
    }

    std::string_view text_;
    std::vector<Node>& nodes_;
    std::vector<std::string>& names_;
    std::size_t place_ = 0;
    int depth_ = 0;
};

/// By repeated squaring: exact where the products are.
double whole_power(double base, int exponent) {
    double result = 1, square = base;
    for (int rest = std::abs(exponent); rest > 0; rest /= 2) {
        if (rest % 2 == 1) result *= square;
        square *= square;
    }
    return exponent < 0 ? 1 / result : result;
}

double power(double base, double exponent) {
    constexpr double most = 1024;
    if (exponent == std::rint(exponent) && std::abs(exponent) <= most)
        return whole_power(base, static_cast<int>(exponent));
    return general_power(base, exponent);
}

double result_of(const Node& node, double a, double b) {
    switch (node.operation) {
        case Operation::add:
            return a + b;
        case Operation::subtract:
            return a - b;
        case Operation::multiply:
            return a * b;
        case Operation::divide:
            return a / b;
        case Operation::power:
            return power(a, b);
        case Operation::negate:
            return -a;
        case Operation::exp:
            return exponential(a);
        case Operation::log:
            return natural_logarithm(a);
        case Operation::sqrt:
            return std::sqrt(a);
        case Operation::sin:
            return sine(a);
        case Operation::cos:
            return cosine(a);
        case Operation::tan:
            return tangent(a);
        case Operation::tanh:
            return hyperbolic_tangent(a);
        case Operation::abs:
            return std::abs(a);
        case Operation::min:
            return b < a ? b : a;
        case Operation::max:
            return a < b ? b : a;
        default:
            return node.number;
    }
}

}  // namespace

Expression::Expression(std::string_view text) { Parser(text, nodes_, names_).whole(); }

double Expression::operator()(std::span<const double> values) const {
    std::vector<double> results;
    results.reserve(nodes_.size());
    for (const Node& node : nodes_) {
        const bool name = node.operation == Operation::name, leaf = name || node.operation == Operation::number;
        results.push_back(name ? values[node.first]
                               : result_of(node, leaf ? 0 : results[node.first], leaf ? 0 : results[node.second]));
    }
    return results.back();
}

bool is_name(std::string_view text) {
    return !text.empty() && is_letter(text[0]) &&
           std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

}  // namespace steplab
