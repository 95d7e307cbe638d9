#include "io/data_bonds.hpp"

#include "core/shown.hpp"
#include "io/text_input.hpp"
#include "io/words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace steplab {

namespace {

std::uint64_t id_of(const TextInput& text, std::string_view word) {
    std::uint64_t id = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), id);
    if (result.ec != std::errc{} || result.ptr != word.data() + word.size() || id == 0)
        text.fail("a bond has a number, a type and the ids of two atoms, from 1");
    return id - 1;
}

/// True if a section begins with this line: it has a name.
bool names_section(std::string_view word) { return word.front() >= 'A' && word.front() <= 'Z'; }

}  // namespace

std::vector<DataBond> read_data_bonds(const std::string& file) {
    TextInput text{InputFile(file)};
    std::vector<DataBond> bonds;
    std::string told = "0";  // by the head
    bool in_head = true, here = false;
    text.line();  // a title of any words
    while (const auto line = text.line()) {
        const auto words = words_of(line->substr(0, line->find('#')));
        if (words.empty()) continue;
        if (names_section(words.front())) {
            in_head = false;
            here = words.size() == 1 && words.front() == "Bonds";
        } else if (here) {
            if (words.size() < 4) text.fail("a bond has a number, a type and the ids of two atoms, from 1");
            bonds.push_back({id_of(text, words[2]), id_of(text, words[3])});
        } else if (in_head && words.size() == 2 && words[1] == "bonds") {
            told = words[0];
        }
    }
    if (told != std::to_string(bonds.size()))
        text.fail(fmt::format("the file has {} bonds, its head says {}", bonds.size(), shown(told)));
    return bonds;
}

}  // namespace steplab
