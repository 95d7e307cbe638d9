#pragma once

#include "io/file_watch.hpp"
#include "io/output_file.hpp"
#include "io/scene_writer.hpp"
#include "session/lesson.hpp"
#include "session/recording.hpp"
#include "session/shared_scenes.hpp"
#include "sim/run/run_description.hpp"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace steplab {

/// Reads and writes scene files, and writes sessions, on a thread of its own, because large ones take long, and watches
/// the file of the scene that is shown and the files that it reads. Every call returns at once.
class SceneFiles {
public:
    /// What a job came to.
    struct News {
        enum class Kind { opened, session, trajectory, lesson, read_again, saved, failed };
        Kind kind = Kind::failed;
        std::optional<RunDescription> scene = {};  ///< opened, read_again: as the file describes it
        std::optional<Recording> session = {};     ///< session: to be played
        std::optional<Lesson> lesson = {};         ///< lesson: to be opened
        std::string text = {};                     ///< trajectory: its path; saved: the file; failed: the message
    };

    /// `wake` is called on the thread when there are news.
    explicit SceneFiles(void (*wake)());
    ~SceneFiles();
    SceneFiles(const SceneFiles&) = delete;
    SceneFiles& operator=(const SceneFiles&) = delete;

    /// Reads the file of a scene, a session, a trajectory or a lesson, or a shipped scene by its name. `~/` at the
    /// front is the user's own folder.
    void open(const std::string& name);
    /// Reads a shipped lesson.
    void open_lesson(const std::string& name);
    /// Writes the scene of a run to a new file in the current folder.
    void save(const RunDescription& run, const SceneView& view);
    /// Writes a session to a new file there, once it is known.
    void save_session(std::shared_future<Recording> recording);
    /// The same to a file that was opened before.
    void finish_session(std::shared_ptr<OutputFile> file, std::shared_future<Recording> recording);
    /// The scene that is shown: its file, if it is one, is read again when it has changed since this scene was read
    /// from it.
    void watch(const RunDescription& shown);
    /// The next news; none if there are none.
    std::optional<News> take();

private:
    using Job = std::function<void()>;
    void post(Job job);
    void work();
    void watch_files();
    void read_again();
    void write_new(std::string_view name, std::string_view end, const std::string& text);
    void report_read(News news);
    void report(News news);
    template <class Work>
    void attempt(const Work& work);
    void fail(const char* message) noexcept;

    void (*wake_)();
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::deque<News> news_;
    bool without_memory_ = false;  ///< for one of them
    bool stopping_ = false;
    // of the thread
    SharedScenes scenes_;
    FileWatch files_;
    std::vector<std::filesystem::path> watched_files_;
    SceneOrigin watched_;  ///< as it was read last
    bool failed_ = false;  ///< the last time it was read again
    bool watching_ = false;
    std::thread thread_;
};

}  // namespace steplab
