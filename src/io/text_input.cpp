#include "io/text_input.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

constexpr std::size_t read_at_once = std::size_t{1} << 18;

}  // namespace

TextInput::TextInput(std::string name, Source source)
    : name_(std::move(name)), source_(std::move(source)), decompressor_(decompressor(compression_in(source_(0, 4)))) {}

TextInput::TextInput(const std::shared_ptr<const InputFile>& file)
    : TextInput(file->name(), [file](std::uint64_t place, std::uint64_t bytes) { return file->read(place, bytes); }) {}

TextInput::TextInput(std::string name, const std::shared_ptr<const InputFile>& file, std::uint64_t begin,
                     std::uint64_t end, std::uint64_t lines)
    : name_(std::move(name)),
      source_([file, end](std::uint64_t from, std::uint64_t bytes) {
          return from < end ? file->read(from, std::min(bytes, end - from)) : std::string();
      }),
      place_(begin),
      lines_(lines) {}

TextInput::TextInput(InputFile file) : TextInput(std::make_shared<const InputFile>(std::move(file))) {}

TextInput::TextInput(std::string name, std::shared_ptr<const std::string> text)
    : TextInput(std::move(name), [held = std::move(text)](std::uint64_t place, std::uint64_t bytes) {
          return held->substr(std::min<std::uint64_t>(place, held->size()), bytes);
      }) {}

bool TextInput::fill() {
    text_.erase(0, taken_);
    taken_ = 0;
    if (decompressor_) return decompress();
    const std::string part = source_(place_, read_at_once);
    place_ += part.size();
    text_ += part;
    return !part.empty();
}

/// Until there is more text; false at the end of the file.
bool TextInput::decompress() {
    for (const std::size_t before = text_.size(); text_.size() == before;) {
        if (used_ == raw_.size() && !more_) {
            raw_ = source_(place_, read_at_once);
            used_ = 0;
            place_ += raw_.size();
            if (raw_.empty() && decompressor_->complete()) return false;
            if (raw_.empty()) fail("its compressed data is truncated");
        }
        try {
            std::string_view left = std::string_view(raw_).substr(used_);
            more_ = decompressor_->take(left, text_);
            used_ = raw_.size() - left.size();
        } catch (const FileError& error) {
            fail(fmt::format("its compressed data is damaged ({})", error.what()));
        }
    }
    return true;
}

std::string_view TextInput::peek(std::size_t bytes) {
    while (text_.size() - taken_ < bytes && fill()) {
    }
    return std::string_view(text_).substr(taken_, bytes);
}

std::string TextInput::rest(std::size_t most) {
    do {
        if (text_.size() - taken_ > most) fail(fmt::format("it holds more than the {} bytes that fit in memory", most));
    } while (fill());
    return std::exchange(text_, {}).substr(std::exchange(taken_, 0));
}

std::optional<std::string_view> TextInput::line() {
    std::size_t searched = 0, end = 0;
    while ((end = text_.find('\n', taken_ + searched)) == std::string::npos) {
        searched = text_.size() - taken_;
        if (searched > longest_text_line) {
            ++lines_;
            fail("it is too long for CSV or XYZ");
        }
        if (fill()) continue;
        if (text_.empty()) return std::nullopt;
        end = text_.size();  // the last line has no end
        break;
    }
    std::string_view line = std::string_view(text_).substr(taken_, end - taken_);
    taken_ = end < text_.size() ? end + 1 : end;
    ++lines_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

void TextInput::fail(const std::string& reason) const {
    const std::string line = lines_ == 0 ? "" : fmt::format("line {}: ", lines_);
    throw FileError(fmt::format("cannot read '{}': {}{}", shown(name_), line, reason));
}

}  // namespace steplab
