#include "core/program_end.hpp"

#include "core/shown.hpp"

#include <climits>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

// What end_program() calls may be called in a signal handler: it takes no lock and allocates nothing.

namespace steplab {

namespace {

enum class State : int { free, claimed, known };

struct Place {
    std::atomic<State> state = State::free;
    int descriptor = -1;
    UnfinishedFile::AtEnd at_end = UnfinishedFile::AtEnd::removed;
    std::array<char, PATH_MAX> hidden;
    std::array<char, PATH_MAX> kept_as;
    std::array<char, 1024> shown_as;  // what a terminal may be given of it
};

// A signal handler has no other way to them.
constexpr std::size_t most_files = 16;
std::array<Place, most_files> places;
static_assert(std::atomic<State>::is_always_lock_free);

/// What does not fit is left out.
template <std::size_t size>
void copy_text(const std::string& text, std::array<char, size>& to) {
    to[text.copy(to.data(), size - 1)] = '\0';
}

/// Bytes up to the end of the last whole line.
off_t whole_lines(int descriptor, off_t size) {
    std::array<char, 4096> block;
    for (off_t end = size; end > 0;) {
        const off_t begin = std::max<off_t>(0, end - static_cast<off_t>(block.size()));
        const ssize_t got = pread(descriptor, block.data(), static_cast<std::size_t>(end - begin), begin);
        if (got <= 0) return 0;
        const std::string_view text(block.data(), static_cast<std::size_t>(got));
        if (const std::size_t last = text.rfind('\n'); last != std::string_view::npos)
            return begin + static_cast<off_t>(last) + 1;
        end = begin;
    }
    return 0;
}

void say(const char* text) {
    const ssize_t lost = write(STDERR_FILENO, text, std::strlen(text));
    static_cast<void>(lost);
}

/// True if the file stands under its other name.
bool keep(const Place& place) {
    struct stat status {};
    if (place.at_end == UnfinishedFile::AtEnd::removed || fstat(place.descriptor, &status) != 0) return false;
    off_t size = status.st_size;
    if (place.at_end == UnfinishedFile::AtEnd::kept_in_lines) size = whole_lines(place.descriptor, size);
    if (size == 0 || rename(place.hidden.data(), place.kept_as.data()) != 0) return false;
    if (size < status.st_size && ftruncate(place.descriptor, size) != 0) return true;
    say("steplab: output so far is kept in '");
    say(place.shown_as.data());
    say("'\n");
    return true;
}

}  // namespace

UnfinishedFile::UnfinishedFile(int descriptor, const std::string& hidden, AtEnd at_end, const std::string& kept_as)
    : place_(hidden.size() < PATH_MAX && kept_as.size() < PATH_MAX ? 0 : most_files) {
    State free = State::free;
    while (place_ < most_files && !places[place_].state.compare_exchange_strong(free, State::claimed)) {
        free = State::free;
        ++place_;
    }
    if (place_ == most_files) return;
    Place& place = places[place_];
    place.descriptor = descriptor;
    place.at_end = at_end;
    copy_text(hidden, place.hidden);
    copy_text(kept_as, place.kept_as);
    copy_text(shown(kept_as), place.shown_as);
    place.state = State::known;
}

UnfinishedFile::~UnfinishedFile() {
    if (place_ < most_files) places[place_].state = State::free;
}

void end_program(int exit_code) noexcept {
    for (Place& place : places) {
        State known = State::known;
        if (!place.state.compare_exchange_strong(known, State::claimed)) continue;
        if (!keep(place)) unlink(place.hidden.data());
    }
    _exit(exit_code);
}

}  // namespace steplab
