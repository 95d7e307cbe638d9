#pragma once

#include "core/program_end.hpp"
#include "io/compression.hpp"

#include <atomic>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace steplab {

/// The reader of a pipe closed it (`| head`): not an error, the program ends quietly with exit code 0.
class ReaderGone : public std::exception {
public:
    const char* what() const noexcept override { return "the reader closed the output"; }
};

/// Output to a file, a device, a pipe or standard output ("-").
///
/// A file appears whole or not at all: its bytes go to a hidden file in the same folder, which commit() syncs and
/// renames. Links are followed; an existing file keeps its permissions. Devices, pipes and standard output are written
/// directly. Without commit() (an exception) the old file stays as it was and nothing else is left. What a program that
/// was killed has left is removed by the next one that writes into the folder.
///
///     OutputFile file("picture.png");
///     file.write(bytes);
///     file.commit();
class OutputFile {
public:
    /// Throws FileError if the file cannot be written: missing folder, a folder itself, no permission. What is written
    /// is compressed on the way to the file.
    explicit OutputFile(std::string name, Compression compression = Compression::none);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes all bytes, in blocks. Throws FileError (disk full ...) naming file and reason, ReaderGone for a closed
    /// pipe, Interrupted while it waits for a reader (on any thread).
    void write(std::string_view bytes);
    /// To be called from another thread when the file is no longer needed: a write that waits for a reader then throws
    /// ReaderGone.
    void stop_waiting() { waits_ = false; }
    /// What is made of the file if end_program() comes before it is complete: otherwise it is removed.
    void at_program_end(UnfinishedFile::AtEnd what);
    /// Passes buffered bytes to the system, so that the reader of a pipe or terminal gets them.
    void flush();
    /// The file is complete: puts it in place. Throws as write() does; Interrupted if a signal has come, the old file
    /// stays then.
    void commit();
    /// Keeps an incomplete file as NAME.partial and returns that name. None if it is not a regular file or nothing was
    /// written.
    std::optional<std::string> keep_partial();

    /// The open file, for another program to write in place of write(). It has a name of its own only after commit().
    int descriptor() const { return descriptor_; }
    /// The name for messages: "standard output" for "-".
    const std::string& name() const { return name_; }

private:
    std::string partial_name() const { return target_.string() + ".partial"; }
    void open_beside();
    bool create_hidden(const std::filesystem::path& candidate);
    void open_directly(const std::string& path);
    void put_in_place(const std::filesystem::path& place);
    void put(std::string_view bytes);
    void send_buffer();
    void end_compression();
    void send(std::string_view bytes);
    void wait_for_reader() const;
    [[noreturn]] void fail(std::string_view action, int error) const;

    std::string name_;
    std::filesystem::path target_;     ///< the regular file to write; empty for all else
    std::filesystem::path temporary_;  ///< the hidden file, while there is one
    int descriptor_ = -1;
    bool owns_descriptor_ = false;
    std::optional<UnfinishedFile> unfinished_;
    std::size_t piece_ = 0;  ///< most bytes of one system call
    std::atomic<bool> waits_ = true;
    std::string buffer_;
    std::unique_ptr<Compressor> compressor_;  ///< null: bytes go to the file as they are
    std::string compressed_;                  ///< memory for what it returns
};

/// True if both names lead to one file, pipe or standard output, so that two outputs would overwrite each other. False
/// for devices such as /dev/null and for terminals, which accept any number of outputs.
bool same_output(const std::string& a, const std::string& b);

/// True for "-", devices and pipes, which are written in place and need no file name extension.
bool written_directly(const std::string& name);

}  // namespace steplab
