// Expressions of any text: each is parsed or refused at one of its characters, and what is parsed has a value.

#include "core/expression.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace steplab;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const Expression expression(text);
        const auto nodes = expression.nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            using Operation = Expression::Operation;
            const Operation operation = nodes[i].operation;
            if (operation == Operation::number) continue;
            const std::size_t before = operation == Operation::name ? expression.names().size() : i;
            if (nodes[i].first >= before) std::abort();  // each comes after those it depends on
        }
        expression(std::vector<double>(expression.names().size(), 0.5));
    } catch (const ExpressionError& error) {
        if (error.place() > size) std::abort();
    }
    return 0;
}
