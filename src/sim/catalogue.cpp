#include "sim/catalogue.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "sim/own_methods.hpp"

#include <algorithm>
#include <vector>

namespace steplab {

namespace {

template <class Entry>
const Entry& find(std::string_view kind, std::span<const Entry> entries, std::string_view id,
                  std::vector<std::string_view> known = {}) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.info.id == id; });
    if (found != entries.end()) return *found;
    for (const auto& entry : entries) known.push_back(entry.info.id);
    throw UsageError(unknown_word(kind, id, known));
}

}  // namespace

const Model& model(std::string_view id) { return find("model", models(), id); }
const Method& method(std::string_view id) {
    const Method* const own = own_method(id);
    return own ? *own : find("method", methods(), id, own_method_ids());
}

}  // namespace steplab
