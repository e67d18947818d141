// Unmodified programs draw in windows. Their pixels are read from the server.
#include "tests/gl/x11/client.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <utility>

namespace {

class GlxPrograms : public Glx {
protected:
    void TearDown() override {
        if (child_ > 0) {
            kill(child_, SIGTERM);
            waitpid(child_, nullptr, 0);
        }
        Glx::TearDown();
    }

    /// Starts a program that finds our libGL first.
    void start(const std::vector<const char*>& words) {
        child_ = fork();
        ASSERT_GE(child_, 0);
        if (child_ > 0) return;
        setenv("LD_LIBRARY_PATH", GW_OPENGL_FOLDER, 1);
        std::vector<char*> arguments;
        for (const char* word : words) arguments.push_back(const_cast<char*>(word));
        arguments.push_back(nullptr);
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }

    /// The exit status of the program; -1 after a signal.
    int wait_for_end() {
        int status = 0;
        waitpid(std::exchange(child_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    /// The window below `parent` whose title begins so; 0: there is none.
    Window find(Window parent, const std::string& title) const {
        Window root = 0, above = 0, *children = nullptr, found = 0;
        unsigned count = 0;
        if (!XQueryTree(display, parent, &root, &above, &children, &count)) return 0;
        for (unsigned i = 0; i < count && found == 0; ++i) {
            char* name = nullptr;
            XFetchName(display, children[i], &name);
            if (name != nullptr && std::string(name).rfind(title, 0) == 0) found = children[i];
            if (name != nullptr) XFree(name);
            if (found == 0) found = find(children[i], title);
        }
        if (children != nullptr) XFree(children);
        return found;
    }

    /// The first picture of a program's window in which a condition holds; else the last one.
    Shown wait_for(const std::string& title, int width, int height,
                   const std::function<bool(const Shown&)>& condition) {
        Shown image;
        for (int attempt = 0; attempt < 600; ++attempt) {
            const timespec pause{0, 50'000'000};
            nanosleep(&pause, nullptr);
            const Window found = find(RootWindow(display, DefaultScreen(display)), title);
            XWindowAttributes attributes{};
            if (found == 0 || !XGetWindowAttributes(display, found, &attributes)) continue;
            if (attributes.map_state != IsViewable) continue;
            image = shown(found, width, height);
            if (condition(image)) break;
        }
        return image;
    }

private:
    pid_t child_ = -1;
};

std::map<unsigned long, int> histogram(const Shown& image) {
    std::map<unsigned long, int> counts;
    for (const unsigned long pixel : image.pixels) ++counts[pixel];
    return counts;
}

bool exists(const char* program) {
    return std::filesystem::exists(std::string("/usr/bin/") + program);
}

/// [mesa-utils] Three gears, red, green and blue, on black.
TEST_F(GlxPrograms, GearsTurn) {
    ASSERT_TRUE(exists("glxgears")) << "scripts/setup installs mesa-utils";
    start({"glxgears", "-geometry", "300x300"});
    const auto channel = [](unsigned long pixel, unsigned long mask) {
        return double(pixel & mask) / double(mask);
    };
    const Visual& visual = *DefaultVisual(display, DefaultScreen(display));
    const auto mostly = [&](const Shown& image, unsigned long mask) {
        return std::count_if(image.pixels.begin(), image.pixels.end(), [&](unsigned long pixel) {
            double others = 0;
            for (const unsigned long other : {visual.red_mask, visual.green_mask, visual.blue_mask})
                if (other != mask) others = std::max(others, channel(pixel, other));
            return channel(pixel, mask) > others + 0.2;
        });
    };
    const auto has_gears = [&](const Shown& image) {
        return mostly(image, visual.red_mask) > 1000 && mostly(image, visual.green_mask) > 1000 &&
               mostly(image, visual.blue_mask) > 1000;
    };
    const Shown first = wait_for("glxgears", 300, 300, has_gears);
    ASSERT_TRUE(has_gears(first));
    EXPECT_EQ(first.at(2, 2), 0u);
    const Shown later = wait_for("glxgears", 300, 300,
                                 [&](const Shown& image) { return image.pixels != first.pixels; });
    EXPECT_NE(later.pixels, first.pixels);
}

TEST_F(GlxPrograms, ExitHandlersMayLeaveTheContext) {
    start({GW_EXIT_PROGRAM});
    EXPECT_EQ(wait_for_end(), 0);
}

TEST_F(GlxPrograms, MayExitWhileThreadsDraw) {
    for (int run = 0; run < 20; ++run) {
        start({GW_ENDS_PROGRAM, "exit"});
        EXPECT_EQ(wait_for_end(), 7);
    }
}

TEST_F(GlxPrograms, SignalsAreForTheProgramsOwnThreads) {
    start({GW_ENDS_PROGRAM, "signals"});
    EXPECT_EQ(wait_for_end(), 0);
}

TEST_F(GlxPrograms, AChildDrawsToADisplayOfItsOwn) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "the thread sanitizer starts no threads in a child";
#endif
    start({GW_ENDS_PROGRAM, "fork"});
    EXPECT_EQ(wait_for_end(), 0);
}

/// A program that is linked with the parts of libGL.so.1 under their own names.
TEST_F(GlxPrograms, SplitLibrariesFindTheMachine) {
    ASSERT_TRUE(std::filesystem::exists(GW_SPLIT_PROGRAM)) << "scripts/setup installs libegl1";
    start({GW_SPLIT_PROGRAM});
    EXPECT_EQ(wait_for_end(), 0);
}

/// A program of freeglut: a yellow square in the lower left quarter of a window of 200 x 100.
TEST_F(GlxPrograms, FreeglutDraws) {
    ASSERT_TRUE(std::filesystem::exists(GW_GLUT_PROGRAM)) << "scripts/setup installs freeglut";
    start({GW_GLUT_PROGRAM});
    const auto is_drawn = [&](const Shown& image) {
        return histogram(image)[pixel(true, true, false)] == 100 * 50;
    };
    const Shown image = wait_for("square", 200, 100, is_drawn);
    ASSERT_TRUE(is_drawn(image));
    EXPECT_EQ(image.at(0, 99), pixel(true, true, false));
    EXPECT_EQ(image.at(99, 50), pixel(true, true, false));
    EXPECT_EQ(image.at(100, 50), pixel(false, false, true));
}

}  // namespace
