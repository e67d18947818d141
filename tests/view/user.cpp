// A user of gw view: finds its window, drags the mouse, presses keys and reads the window's pixels.
// Usage: gw_view_user FOLDER, which gw view saves into. Ends with 1 and a line if the window does not
// do what it should within a minute.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace std::chrono_literals;

[[noreturn]] void give_up(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(1);
}

/// Looks again and again, for a minute.
void wait_until(const std::string& what, const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!is_so()) {
        if (std::chrono::steady_clock::now() > end) give_up("waited in vain: " + what);
        std::this_thread::sleep_for(20ms);
    }
}

class User {
public:
    explicit User(Display* display) : display_(display) {
        wait_until("a window of gw view", [&] { return find(DefaultRootWindow(display_)); });
        Window child = 0;
        XTranslateCoordinates(display_, window_, DefaultRootWindow(display_), 0, 0, &left_, &top_,
                              &child);
        XSetInputFocus(display_, window_, RevertToParent, CurrentTime);
    }

    /// The picture's part of the window, 320x240.
    std::vector<unsigned long> picture() const { return pixels(0, 0, 320, 240); }
    std::vector<unsigned long> panel() const { return pixels(330, 0, 400, 400); }

    void move(int x, int y) const {
        XTestFakeMotionEvent(display_, -1, left_ + x, top_ + y, CurrentTime);
        XFlush(display_);
        std::this_thread::sleep_for(20ms);
    }
    void button(bool down) const {
        XTestFakeButtonEvent(display_, 1, down, CurrentTime);
        XFlush(display_);
        std::this_thread::sleep_for(20ms);
    }
    void press(KeySym key) const {
        const KeyCode code = XKeysymToKeycode(display_, key);
        XTestFakeKeyEvent(display_, code, True, CurrentTime);
        XTestFakeKeyEvent(display_, code, False, CurrentTime);
        XFlush(display_);
    }
    /// Until two looks in a row are the same.
    std::vector<unsigned long> settled() const {
        std::vector<unsigned long> before = picture();
        wait_until("a picture that stays", [&] {
            std::this_thread::sleep_for(500ms);
            const auto now = picture();
            const bool stays = now == before;
            before = now;
            return stays;
        });
        return before;
    }

private:
    bool find(Window at) {
        char* name = nullptr;
        XWindowAttributes attributes{};
        if (XFetchName(display_, at, &name) != 0 && name != nullptr) {
            const bool is_it = std::string(name).find("gw view") != std::string::npos;
            XFree(name);
            const bool is_there = XGetWindowAttributes(display_, at, &attributes) != 0;
            if (is_it && is_there && attributes.map_state == IsViewable) {
                window_ = at;
                return true;
            }
        }
        Window root = 0, parent = 0, *children = nullptr;
        unsigned count = 0;
        if (XQueryTree(display_, at, &root, &parent, &children, &count) == 0) return false;
        bool found = false;
        for (unsigned i = 0; i < count && !found; ++i) found = find(children[i]);
        if (children != nullptr) XFree(children);
        return found;
    }

    std::vector<unsigned long> pixels(int x, int y, unsigned width, unsigned height) const {
        XImage* image = nullptr;
        wait_until("a window that can be read", [&] {
            image = XGetImage(display_, window_, x, y, width, height, AllPlanes, ZPixmap);
            return image != nullptr;
        });
        std::vector<unsigned long> values;
        for (unsigned row = 0; row < height; ++row)
            for (unsigned column = 0; column < width; ++column)
                values.push_back(XGetPixel(image, int(column), int(row)) & 0xFFFFFF);
        XDestroyImage(image);
        return values;
    }

    Display* display_;
    Window window_ = 0;
    int left_ = 0, top_ = 0;
};

bool has_colors(const std::vector<unsigned long>& pixels) {
    std::vector<unsigned long> seen;
    for (const unsigned long pixel : pixels) {
        bool is_new = true;
        for (const unsigned long known : seen) is_new = is_new && known != pixel;
        if (is_new) seen.push_back(pixel);
        if (seen.size() > 50) return true;
    }
    return false;
}

void look_around(const User& user, const std::filesystem::path& folder) {
    wait_until("a picture with colours", [&] { return has_colors(user.picture()); });
    const auto first = user.settled();
    user.move(100, 100);
    user.button(true);
    for (int x = 110; x <= 180; x += 10) user.move(x, 110);
    wait_until("a picture that follows the mouse", [&] { return user.picture() != first; });
    user.button(false);
    const auto turned = user.settled();
    if (turned == first) give_up("the view is as before the drag");
    user.press(XK_s);
    user.press(XK_p);
    wait_until("a saved view and picture", [&] {
        return std::filesystem::exists(folder / "rings_view_001.toml") &&
               std::filesystem::exists(folder / "rings_view_001.png");
    });
    user.press(XK_Tab);
    wait_until("planes of a pass", [&] { return user.picture() != turned; });
    const auto planes = user.settled();
    for (int i = 0; i < 3; ++i) user.press(XK_period);
    wait_until("planes of another pass", [&] { return user.picture() != planes; });
    user.press(XK_Tab);
    wait_until("the picture again", [&] { return user.picture() == turned; });
    const auto panel = user.panel();
    user.press(XK_r);
    wait_until("another renderer's picture",
               [&] { return user.panel() != panel && user.picture() != turned; });
    user.press(XK_q);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) give_up("usage: gw_view_user FOLDER");
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) give_up("no display");
    // A window that was listed may be gone when it is asked for its name.
    XSetErrorHandler([](Display*, XErrorEvent* error) {
        if (error->error_code == BadWindow || error->error_code == BadDrawable ||
            error->error_code == BadMatch)
            return 0;
        give_up("X error " + std::to_string(error->error_code));
    });
    const User user(display);
    look_around(user, arguments[1]);
    XSync(display, False);
    XCloseDisplay(display);
    return 0;
}
