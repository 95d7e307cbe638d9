#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// The reader of a pipe went away (`| head`): not an error, the program ends quietly with exit code 0.
class ReaderGone : public std::exception {
public:
    const char* what() const noexcept override { return "the reader of the output went away"; }
};

/// Bytes on their way to a file, a device, a pipe or standard output ("-").
///
/// A file appears whole or not at all: its bytes go to a hidden file beside it, and commit() syncs that one and gives
/// it the name. Links are followed; an existing file keeps its permissions. Devices, pipes and standard output are
/// written directly. Whoever leaves without commit() (an exception) leaves nothing behind, and the old file as it was.
///
///     OutputFile file("picture.png");
///     file.write(bytes);
///     file.commit();
class OutputFile {
public:
    /// Throws FileError if the place cannot be written: missing folder, a folder itself, no permission.
    explicit OutputFile(std::string name);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes all bytes, in blocks. Throws FileError (disk full ...) naming file and reason, ReaderGone for a closed
    /// pipe, Interrupted while it waits for a reader (on any thread).
    void write(std::string_view bytes);
    /// From another thread, when nobody cares for the file any more: a write that waits for a reader ends as if that
    /// had gone.
    void stop_waiting() { waits_ = false; }
    /// Sends what is still held back to the system, so that the reader of a pipe or terminal sees it.
    void flush();
    /// The file is complete: it takes its place. Throws as write() does.
    void commit();
    /// The file is not complete but worth keeping: it becomes NAME.partial, whose name is returned. Nothing if it was
    /// not an ordinary file or nothing was written.
    std::optional<std::string> keep_partial();

    /// As messages call it: "standard output" for "-".
    const std::string& name() const { return name_; }

private:
    void open_beside();
    void open_directly(const std::string& path);
    void send(std::string_view bytes);
    void wait_for_reader() const;
    [[noreturn]] void fail(std::string_view action, int error) const;

    std::string name_;
    std::filesystem::path target_;     ///< the ordinary file that is to appear; empty for all else
    std::filesystem::path temporary_;  ///< the hidden file beside it, while there is one
    int descriptor_ = -1;
    bool owns_descriptor_ = false;
    std::size_t piece_ = 0;  ///< the most bytes that one call of the system takes
    std::atomic<bool> waits_ = true;
    std::string held_back_;
};

/// True if both names lead to one file, pipe or standard output, so that two outputs would overwrite each other.
/// Devices such as /dev/null and terminals take any number of outputs.
bool same_output(const std::string& a, const std::string& b);

/// True for "-", devices and pipes: what is written in place and needs no file ending.
bool written_directly(const std::string& name);

}  // namespace steplab
