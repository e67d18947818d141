#include "tests/apps/support/command_test.h"
#include "test_paths.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

void redirect(const std::string& file, int to) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(descriptor, to);
    ::close(descriptor);
}

[[noreturn]] void become(const std::vector<std::string>& words, const Surroundings& around,
                         const std::string& out, const std::string& err) {
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    if (around.largest_file >= 0) {
        const rlimit limit{static_cast<rlim_t>(around.largest_file),
                           static_cast<rlim_t>(around.largest_file)};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (!around.folder.empty() && ::chdir(around.folder.c_str()) != 0) ::_exit(126);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

/// At most a minute.
void wait_for_file(const fs::path& file) {
    for (int i = 0; i < 6000 && !fs::exists(file); ++i) ::usleep(10000);
}

int wait_for(pid_t child, const Surroundings& around) {
    if (around.interrupt_after_ms >= 0)
        ::usleep(static_cast<useconds_t>(around.interrupt_after_ms) * 1000);
    if (!around.interrupt_when.empty()) wait_for_file(around.folder / around.interrupt_when);
    if (around.interrupt_after_ms >= 0 || !around.interrupt_when.empty()) ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Outcome run_process(const std::vector<std::string>& words, const Surroundings& around) {
    const TemporaryFolder folder;
    const std::string out =
        around.stdout_file.empty() ? (folder / "out").string() : around.stdout_file;
    const std::string err = folder / "err";
    const pid_t child = ::fork();
    if (child == 0) become(words, around, out, err);
    Outcome outcome;
    outcome.code = wait_for(child, around);
    if (around.stdout_file.empty()) outcome.out = bytes_of(out);
    outcome.err = bytes_of(err);
    return outcome;
}

Outcome CommandTest::gw(std::vector<std::string> arguments, Surroundings surroundings) const {
    arguments.insert(arguments.begin(), GW_BIN_DIR "/gw");
    if (surroundings.folder.empty()) surroundings.folder = folder_.path();
    return run_process(arguments, surroundings);
}

void CommandTest::expect_refused(int code, const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& parts,
                                 Surroundings surroundings) const {
    const std::vector<std::string> before = names();
    const Outcome outcome = gw(arguments, std::move(surroundings));
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.substr(0, 4), "gw: ");
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    for (const std::string& part : parts) {
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err << "lacks " << part;
    }
    EXPECT_EQ(names(), before);
}

}  // namespace gw::apps
