#include "io/restored_text.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/temporary_folder.hpp"

#include <fmt/format.h>

#include <ios>
#include <string_view>
#include <utility>

namespace steplab {

RestoredText::RestoredText(InputFile compressed)
    : size_(static_cast<double>(compressed.size())), text_(std::move(compressed)) {
    const TemporaryFolder folder;  // open files stay when their folder is removed
    const std::string path = folder.file("text");
    out_.open(path, std::ios::binary);
    file_ = std::make_shared<InputFile>(path);
}

double RestoredText::part() const { return static_cast<double>(text_.bytes_read()) / size_; }

void RestoredText::restore(std::uint64_t bytes) {
    constexpr std::size_t piece = std::size_t{1} << 18;
    for (std::uint64_t done = 0; !whole_ && done < bytes;) {
        const std::string_view part = text_.peek(piece);
        whole_ = part.empty();
        out_.write(part.data(), static_cast<std::streamsize>(part.size()));
        text_.drop(part.size());
        done += part.size();
    }
    if (!out_.flush())
        throw FileError(
            fmt::format("cannot read '{}': its text, without compression, does not fit into the folder for "
                        "temporary files; TMPDIR names another one",
                        shown(text_.name())));
    file_->grow();
}

}  // namespace steplab
