// A program that ends while its threads draw: `exit`, with status 7. An exit handler tries to take one
// of their contexts, as freeglut's does. Or that forks while it draws, and
// whose child draws to a display of its own: `fork`, with status 0 if the child showed its frames. Or
// `signals`: status 0 if they can end it in its own thread only.
#include <GL/glx.h>
#include <X11/Xutil.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>

namespace {

/// A window on a display of its own, with a context that is current in the calling thread.
class Drawing {
public:
    Drawing() : display_(XOpenDisplay(nullptr)) {
        if (display_ == nullptr) std::_Exit(1);
        int list[] = {GLX_RGBA, GLX_DOUBLEBUFFER, None};
        XVisualInfo* const visual = glXChooseVisual(display_, DefaultScreen(display_), list);
        if (visual == nullptr) std::_Exit(1);
        window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 200, 150, 0, 0,
                                      BlackPixel(display_, DefaultScreen(display_)));
        XMapWindow(display_, window_);
        context_ = glXCreateContext(display_, visual, nullptr, 1);
        XFree(visual);
        if (!make_current()) std::_Exit(1);
        glClearColor(1, 1, 1, 1);
    }

    bool make_current() { return glXMakeCurrent(display_, window_, context_) != 0; }

    void draw_frame() {
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
        glXSwapBuffers(display_, window_);
    }

    bool shows_white() {
        glXWaitGL();
        XImage* const image = XGetImage(display_, window_, 1, 1, 1, 1, AllPlanes, ZPixmap);
        if (image == nullptr) return false;
        const unsigned long pixel = XGetPixel(image, 0, 0);
        XDestroyImage(image);
        return pixel == WhitePixel(display_, DefaultScreen(display_));
    }

private:
    Display* display_;
    Window window_ = 0;
    GLXContext context_ = nullptr;
};

constexpr int animation = 40;  // frames, the last of which is still being drawn

std::atomic<Drawing*> of_a_thread = nullptr;

void take_context() {
    if (of_a_thread.load()->make_current()) std::_Exit(2);
}

void exit_while_threads_draw() {
    std::atexit(take_context);
    static std::atomic<int> animations = 0;
    for (int i = 0; i < 2; ++i)
        std::thread([] {
            Drawing drawing;
            of_a_thread = &drawing;
            for (int frame = 1;; ++frame) {
                drawing.draw_frame();
                animations += frame == animation;
                animations.notify_all();
            }
        }).detach();
    for (int n = animations; n < 2; n = animations) animations.wait(n);
    std::exit(7);
}

/// Besides, the child leaves the context that it has from its parent.
int status_of_child() {
    Drawing parents;
    for (int frame = 0; frame < animation; ++frame) parents.draw_frame();
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);
        glFinish();
        Drawing own;
        for (int frame = 0; frame < animation; ++frame) own.draw_frame();
        std::exit(own.shows_white() ? 0 : 2);
    }
    int status = 0;
    waitpid(child, &status, 0);
    for (int frame = 0; frame < animation; ++frame) parents.draw_frame();
    return WIFEXITED(status) && parents.shows_white() ? WEXITSTATUS(status) : 3;
}

bool takes_alarms(const std::filesystem::path& thread) {
    std::ifstream status(thread / "status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("SigBlk:"))
            return (std::stoull(line.substr(7), nullptr, 16) >> (SIGALRM - 1) & 1) == 0;
    return false;
}

int status_of_signals() {
    Drawing drawing;
    for (int frame = 0; frame < animation; ++frame) drawing.draw_frame();
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task"))
        if (thread.path().filename() != std::to_string(getpid()) && takes_alarms(thread.path()))
            return 2;
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view how = count == 2 ? arguments[1] : "";
    if (how == "exit") exit_while_threads_draw();
    if (how == "signals") return status_of_signals();
    return how == "fork" ? status_of_child() : 1;
}
