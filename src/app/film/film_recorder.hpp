// A film that a window takes: encoded and written by a thread of its own.
#pragma once

#include "app/film/film.hpp"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace steplab {

/// Takes pictures for a film and writes them beside whatever else is done. No call but finish() and the
/// destructor waits for a picture to be encoded.
class FilmRecorder {
public:
    /// `wake` is called on the thread when a picture was written, and when the film has ended. Throws as make_film()
    /// does.
    FilmRecorder(const FilmFormat& format, void (*wake)());
    /// Completes the file.
    ~FilmRecorder();
    FilmRecorder(const FilmRecorder&) = delete;
    FilmRecorder& operator=(const FilmRecorder&) = delete;

    const FilmFormat& format() const { return format_; }
    /// True if there is room for a picture.
    bool is_ready() const;
    /// The picture of frame `frames` - 1. Frames between the last one and this show the last one again. To be called
    /// when it is ready.
    void add(Picture picture, std::uint64_t frames);
    /// How many frames it has.
    std::uint64_t frames() const { return frames_; }
    /// No more pictures come: the file is completed.
    void end();
    /// The same, and waits until it is complete, or has failed.
    void finish();
    /// True once the file is complete, or has failed.
    bool is_over() const;
    /// Why it failed, and what is left of it; empty as long as it has not.
    std::string failure() const;

private:
    struct Frame {
        Picture picture;
        std::uint64_t frames = 0;
    };
    void work();
    void write();
    std::string kept();
    std::string failure_text(const std::exception& error) noexcept;
    std::optional<Frame> next();

    FilmFormat format_;
    void (*wake_)();
    std::unique_ptr<Film> film_;
    std::uint64_t frames_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Frame> waiting_;
    bool ending_ = false;
    bool over_ = false;
    std::string failure_;
    std::thread thread_;
};

}  // namespace steplab
