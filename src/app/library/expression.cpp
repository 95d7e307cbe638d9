#include "core/number_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <steplab/error.hpp>
#include <steplab/expression.hpp>
#include <utility>

namespace steplab::library {

namespace {

std::string joined(const std::string& a, char sign, const std::string& b) {
    return fmt::format("({} {} {})", a, sign, b);
}

std::string called(const char* function, const std::string& argument) {
    return fmt::format("{}({})", function, argument);
}

std::string finite(double number) {
    if (!std::isfinite(number)) throw UsageError("a formula needs finite numbers");
    return number < 0 ? fmt::format("({})", number_text(number)) : number_text(number);
}

}  // namespace

Expression::Expression(Text, std::string text) : text_(std::move(text)) {}
Expression::Expression(double number) : text_(finite(number)) {}
Expression Expression::named(const std::string& name) { return {Text(), name}; }

Expression operator+(const Expression& a, const Expression& b) {
    return {Expression::Text(), joined(a.text_, '+', b.text_)};
}
Expression operator-(const Expression& a, const Expression& b) {
    return {Expression::Text(), joined(a.text_, '-', b.text_)};
}
Expression operator*(const Expression& a, const Expression& b) {
    return {Expression::Text(), joined(a.text_, '*', b.text_)};
}
Expression operator/(const Expression& a, const Expression& b) {
    return {Expression::Text(), joined(a.text_, '/', b.text_)};
}
Expression operator-(const Expression& a) { return {Expression::Text(), called("-", a.text_)}; }
Expression pow(const Expression& base, const Expression& exponent) {
    return {Expression::Text(), joined(base.text_, '^', exponent.text_)};
}
Expression exp(const Expression& a) { return {Expression::Text(), called("exp", a.text_)}; }
Expression log(const Expression& a) { return {Expression::Text(), called("log", a.text_)}; }
Expression sqrt(const Expression& a) { return {Expression::Text(), called("sqrt", a.text_)}; }
Expression sin(const Expression& a) { return {Expression::Text(), called("sin", a.text_)}; }
Expression cos(const Expression& a) { return {Expression::Text(), called("cos", a.text_)}; }
Expression tanh(const Expression& a) { return {Expression::Text(), called("tanh", a.text_)}; }

}  // namespace steplab::library
