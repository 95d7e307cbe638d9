#include "io/temporary_folder.hpp"
#include "shell.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace steplab::repository {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// The scripts with programs of the test's own before, or instead of, those of the system.
class Scripts : public testing::Test {
protected:
    /// A program in PATH that writes its name and arguments to the file `calls`, prints `output` and ends with `code`.
    void put_recorder(const std::string& name, int code, const std::string& output = {}) const {
        std::ofstream(programs() / name) << "#!/bin/bash\necho \"" << name << " $*\" >> " << folder_.file("calls")
                                         << "\necho '" << output << "'\nexit " << code << '\n';
        fs::permissions(programs() / name, fs::perms::owner_all);
    }

    /// A command in a shell that has read scripts/lib.sh.
    docs::Outcome with_functions(const std::string& command) const {
        return docs::run("source '" STEPLAB_SOURCE_DIR "/scripts/lib.sh'; " + command + " 2>&1", folder_.path(),
                         programs());
    }

    bool was_called(const std::string& name) const {
        std::ifstream calls(folder_.file("calls"));
        for (std::string line; std::getline(calls, line);) {
            if (line.starts_with(name)) return true;
        }
        return false;
    }

    fs::path programs() const {
        fs::create_directories(folder_.file("programs"));
        return folder_.file("programs");
    }

private:
    TemporaryFolder folder_;
};

TEST_F(Scripts, list_of_packages_is_read_by_section) {
    const std::string core = with_functions("entries core").output;
    EXPECT_THAT(core, HasSubstr("cmake\n"));
    EXPECT_THAT(core, Not(HasSubstr("libglfw3-dev")));
    EXPECT_THAT(core, Not(HasSubstr("#")));
    EXPECT_THAT(with_functions("entries core graphics").output, HasSubstr("libglfw3-dev\n"));
}

TEST_F(Scripts, memory_that_grows_is_found_and_large_scenes_are_not) {
    // each of the numbers so many times in a row
    const auto grows = [&](const std::string& measured, int times = 60) {
        return with_functions("all=(); for mb in " + measured + "; do for i in {1.." + std::to_string(times) +
                              "}; do all+=($mb); done; done; memory_grows ${all[*]} && echo it grows")
            .output;
    };
    EXPECT_THAT(grows("175 190 205 290 208 240 280 250"), Not(HasSubstr("it grows"))) << "large scenes";
    EXPECT_THAT(grows("100 175 200 200 200 200 200 230"), Not(HasSubstr("it grows"))) << "what is used first";
    EXPECT_THAT(grows("175 190 200 220 240 260 280 300"), HasSubstr("it grows")) << "80 MB since the middle";
    EXPECT_THAT(grows("175 190 200 220 240 260 280 300", 10), Not(HasSubstr("it grows"))) << "in some minutes";
    EXPECT_THAT(grows("175 190 200 220 240 260 380 400", 10), HasSubstr("it grows"));
    EXPECT_THAT(grows("1100 1190 1800 1810 1800 1860 1885 1880"), Not(HasSubstr("it grows"))) << "sanitizers";
    EXPECT_THAT(grows("1100 1190 1800 1810 1800 1860 1985 1980"), HasSubstr("it grows"));
}

TEST_F(Scripts, installed_packages_need_no_apt) {
    put_recorder("apt-get", 1);
    put_recorder("apt-cache", 1);
    put_recorder("dpkg-query", 0, "installed");
    EXPECT_EQ(with_functions("ensure_packages core graphics tests checks").code, 0);
    EXPECT_FALSE(was_called("apt"));
}

TEST_F(Scripts, missing_packages_are_named_and_installed_without_a_question) {
    put_recorder("apt-get", 0);
    put_recorder("apt-cache", 0);
    put_recorder("dpkg-query", 1);
    const auto outcome = with_functions("as_root() { \"$@\"; }; ensure_packages core");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("installing with apt: g++ cmake"));
    EXPECT_THAT(outcome.output, Not(HasSubstr("ccache")));  // wanted only, and not offered
    EXPECT_TRUE(was_called("apt-get install -q -y --no-install-recommends g++ cmake"));
}

TEST_F(Scripts, failing_apt_ends_with_a_message) {
    put_recorder("apt-get", 100);
    put_recorder("apt-cache", 0);
    put_recorder("dpkg-query", 1);
    const auto outcome = with_functions("as_root() { \"$@\"; }; ensure_packages core");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.output, HasSubstr("apt could not install: g++"));
}

TEST_F(Scripts, no_right_to_install_ends_with_the_command_to_run) {
    put_recorder("apt-get", 0);
    put_recorder("apt-cache", 0);
    put_recorder("dpkg-query", 1);
    const auto outcome = with_functions("as_root() { return 1; }; ensure_packages core");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.output, HasSubstr("apt-get install --no-install-recommends g++ cmake"));
    EXPECT_FALSE(was_called("apt-get"));
}

TEST_F(Scripts, missing_package_that_is_only_wanted_stops_nobody) {
    put_recorder("apt-cache", 0, "ccache | 4.7.5 | offered");
    std::ofstream(programs() / "dpkg-query") << "#!/bin/bash\n[[ $* == *ccache ]] || echo installed\n";
    fs::permissions(programs() / "dpkg-query", fs::perms::owner_all);
    const auto outcome = with_functions("as_root() { return 1; }; missing_packages core; ensure_packages core");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("ccache"));
}

TEST_F(Scripts, system_without_apt_is_told_what_to_do) {
    const auto outcome = with_functions("PATH=/nowhere; basename() { echo test.sh; }; ensure_packages core");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.output, HasSubstr("there is no apt here"));
    EXPECT_THAT(outcome.output, HasSubstr("scripts/packages.txt"));
}

TEST_F(Scripts, help_is_given_before_anything_is_installed) {
    put_recorder("apt-get", 1);
    put_recorder("dpkg-query", 1);
    for (const char* script : {"run.sh", "test.sh", "benchmark.sh", "sanitize.sh", "fuzz.sh", "package.sh",
                               "bare-debian.sh", "tarball.sh", "bare-tarball.sh", "docs.sh"}) {
        const auto outcome =
            docs::run(std::string(STEPLAB_SOURCE_DIR "/scripts/") + script + " --help", "/", programs());
        EXPECT_EQ(outcome.code, 0);
        EXPECT_THAT(outcome.output, HasSubstr(std::string("scripts/") + script));
    }
    EXPECT_FALSE(was_called("dpkg-query"));
}

}  // namespace
}  // namespace steplab::repository
