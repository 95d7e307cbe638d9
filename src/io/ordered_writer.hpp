#pragma once

#include "io/output_file.hpp"

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace steplab {

/// Makes blocks of text on several threads and writes them in the order in which they were submitted. A number takes
/// about 40 ns to format, so one core makes some 400 MB/s: enough for most disks, and this doubles it with each core.
class OrderedWriter {
public:
    /// Makes the text of one block; called on some thread, once.
    using Block = std::function<std::string()>;

    explicit OrderedWriter(OutputFile& file);
    ~OrderedWriter();
    OrderedWriter(const OrderedWriter&) = delete;
    OrderedWriter& operator=(const OrderedWriter&) = delete;

    /// Never holds more than a few blocks: writes the oldest ones when there are. Throws what OutputFile::write throws.
    void submit(Block block);
    /// Waits for all blocks and hands them to the file.
    void drain();

private:
    void work(const std::stop_token& stop);
    void write_oldest();

    OutputFile& file_;
    std::mutex mutex_;
    std::condition_variable_any ready_;
    std::deque<std::packaged_task<std::string()>> waiting_;
    std::deque<std::future<std::string>> under_way_;
    std::vector<std::jthread> threads_;
};

}  // namespace steplab
