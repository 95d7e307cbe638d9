// How soon a program answers a signal, whatever it is doing:  answer_times PROGRAM COMMANDS MOMENTS [SEED]
//
// COMMANDS is a file with a command line of the program a line, behind the seconds within which it is interrupted.
// Each is begun MOMENTS times and gets SIGINT or SIGTERM after a random time. Prints for each the worst and the median
// time from the signal to the end of the process, and how it ended; fails if one took longer than a second, ended by
// another code than 128 + n or left a hidden file in the working folder.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

struct Command {
    double seconds;
    std::string words;
};

struct Answers {
    std::vector<double> seconds;
    int finished = 0;  ///< before the signal
    int wrong = 0;
};

std::vector<Command> commands_in(const char* file) {
    std::vector<Command> commands;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        Command command;
        words >> command.seconds >> std::ws;
        std::getline(words, command.words);
        commands.push_back(command);
    }
    return commands;
}

pid_t start(const char* program, const std::string& line) {
    std::istringstream text(line);
    std::vector<std::string> words{program};
    for (std::string word; text >> word;) words.push_back(word);
    const pid_t process = fork();
    if (process != 0) return process;
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int descriptor : {0, 1, 2}) dup2(nowhere, descriptor);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(program, arguments.data());
    _exit(127);
}

bool left_hidden_file() {
    const auto is_hidden = [](const auto& entry) { return entry.path().filename().string().starts_with(".steplab-"); };
    return std::any_of(std::filesystem::directory_iterator("."), {}, is_hidden);
}

void interrupt(const char* program, const Command& command, std::mt19937_64& random, Answers& answers) {
    const int signal = random() % 2 == 0 ? SIGINT : SIGTERM;
    const double after = command.seconds * static_cast<double>(random() >> 11) * 0x1p-53;
    const pid_t process = start(program, command.words);
    std::this_thread::sleep_for(std::chrono::duration<double>(after));
    const auto begin = Clock::now();
    kill(process, signal);
    int status = 0;
    waitpid(process, &status, 0);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        ++answers.finished;
        return;
    }
    answers.seconds.push_back(seconds);
    // a signal before the program's first lines ends it as every program
    const bool right = WIFSIGNALED(status) ? WTERMSIG(status) == signal : WEXITSTATUS(status) == 128 + signal;
    if (!right || left_hidden_file()) ++answers.wrong;
}

bool print(const Command& command, Answers& answers) {
    std::sort(answers.seconds.begin(), answers.seconds.end());
    const double worst = answers.seconds.empty() ? 0 : answers.seconds.back();
    const double median = answers.seconds.empty() ? 0 : answers.seconds[answers.seconds.size() / 2];
    std::printf("%7.3f %7.3f %8zu %8d %5d  %s\n", worst, median, answers.seconds.size(), answers.finished,
                answers.wrong, command.words.c_str());
    std::fflush(stdout);
    return worst < 1 && answers.wrong == 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("answer_times PROGRAM COMMANDS MOMENTS [SEED]\n", stderr);
        return 2;
    }
    std::mt19937_64 random(argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1);
    std::puts("WORST/s MEDIAN/s ANSWERS FINISHED WRONG  COMMAND");
    bool good = true;
    for (const Command& command : commands_in(argv[2])) {
        Answers answers;
        for (int i = std::atoi(argv[3]); i > 0; --i) interrupt(argv[1], command, random, answers);
        good = print(command, answers) && good;
    }
    return good ? 0 : 1;
}
