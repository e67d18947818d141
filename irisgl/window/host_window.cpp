#include "irisgl/window/host_window.h"

#include "gl/x11/geometry.h"
#include "gl/x11/shown_image.h"

#include <X11/Xutil.h>
#include <X11/cursorfont.h>
#include <X11/keysym.h>
#include <poll.h>

#include <cstdlib>
#include <vector>

namespace gw::irisgl {

namespace {

using namespace gw::gl::x11;

struct KeyName {
    KeySym symbol;
    unsigned device;
};
constexpr KeyName keys[] = {{XK_Escape, ESCKEY},
                            {XK_Tab, TABKEY},
                            {XK_Return, RETKEY},
                            {XK_BackSpace, BACKSPACEKEY},
                            {XK_Delete, DELKEY},
                            {XK_space, SPACEKEY},
                            {XK_Left, LEFTARROWKEY},
                            {XK_Right, RIGHTARROWKEY},
                            {XK_Up, UPARROWKEY},
                            {XK_Down, DOWNARROWKEY},
                            {XK_Shift_L, LEFTSHIFTKEY},
                            {XK_Shift_R, RIGHTSHIFTKEY},
                            {XK_Control_L, LEFTCTRLKEY},
                            {XK_Control_R, RIGHTCTRLKEY},
                            {XK_Alt_L, LEFTALTKEY},
                            {XK_Alt_R, RIGHTALTKEY},
                            {XK_minus, MINUSKEY},
                            {XK_equal, EQUALKEY},
                            {XK_comma, COMMAKEY},
                            {XK_period, PERIODKEY},
                            {XK_slash, VIRGULEKEY},
                            {XK_semicolon, SEMICOLONKEY},
                            {XK_apostrophe, QUOTEKEY},
                            {XK_bracketleft, LEFTBRACKETKEY},
                            {XK_bracketright, RIGHTBRACKETKEY},
                            {XK_backslash, BACKSLASHKEY},
                            {XK_Home, HOMEKEY},
                            {XK_End, ENDKEY},
                            {XK_Page_Up, PAGEUPKEY},
                            {XK_Page_Down, PAGEDOWNKEY},
                            {XK_Insert, INSERTKEY},
                            {XK_KP_Enter, PADENTER},
                            {XK_KP_0, PAD0},
                            {XK_KP_1, PAD1},
                            {XK_KP_2, PAD2},
                            {XK_KP_3, PAD3},
                            {XK_KP_4, PAD4},
                            {XK_KP_5, PAD5},
                            {XK_KP_6, PAD6},
                            {XK_KP_7, PAD7},
                            {XK_KP_8, PAD8},
                            {XK_KP_9, PAD9},
                            {XK_F1, F1KEY},
                            {XK_F2, F2KEY},
                            {XK_F3, F3KEY},
                            {XK_F4, F4KEY},
                            {XK_F5, F5KEY},
                            {XK_F6, F6KEY},
                            {XK_F7, F7KEY},
                            {XK_F8, F8KEY},
                            {XK_F9, F9KEY},
                            {XK_F10, F10KEY},
                            {XK_F11, F11KEY},
                            {XK_F12, F12KEY}};
unsigned device_of(KeySym symbol) {
    if (symbol >= XK_a && symbol <= XK_z) return letter_keys[symbol - XK_a];
    if (symbol >= XK_0 && symbol <= XK_9) return digit_keys[symbol - XK_0];
    for (const KeyName& key : keys)
        if (key.symbol == symbol) return key.device;
    return 0;
}

class XWindow : public HostWindow {
public:
    XWindow(Display* display, const XVisualInfo& visual, const std::string& title, int x, int y,
            int width, int height, bool has_border)
        : display_(display), visual_(visual) {
        const Window root = RootWindow(display, visual.screen);
        XSetWindowAttributes attributes{};
        attributes.colormap = XCreateColormap(display, root, visual.visual, AllocNone);
        attributes.override_redirect = has_border ? False : True;
        attributes.event_mask = ExposureMask | KeyPressMask | KeyReleaseMask | ButtonPressMask |
                                ButtonReleaseMask | PointerMotionMask | StructureNotifyMask |
                                FocusChangeMask;
        window_ = XCreateWindow(display, root, x, top_of(y, height), unsigned(width),
                                unsigned(height), 0, visual.depth, InputOutput, visual.visual,
                                CWColormap | CWEventMask | CWOverrideRedirect | CWBorderPixel,
                                &attributes);
        height_ = height;
        deleted_ = XInternAtom(display, "WM_DELETE_WINDOW", False);
        XSetWMProtocols(display, window_, &deleted_, 1);
        set_title(title);
        XMapWindow(display, window_);
        XSync(display, False);
        image_ = std::make_unique<ShownImage>(display, visual, window_, height);
    }
    ~XWindow() override {
        image_ = nullptr;
        XDestroyWindow(display_, window_);
        XFlush(display_);
    }

    void show(std::span<const std::uint32_t> pixels, int width, int height) override {
        image_->set_target_height(height_);
        image_->show_packed(pixels, width, height);
        XFlush(display_);
    }
    void set_title(const std::string& title) override {
        XStoreName(display_, window_, title.c_str());
    }
    void place(int x, int y, int width, int height) override {
        XMoveResizeWindow(display_, window_, x, top_of(y, height), unsigned(width),
                          unsigned(height));
        height_ = height;
    }
    void raise(bool up) override {
        up ? XRaiseWindow(display_, window_) : XLowerWindow(display_, window_);
    }
    void ring() override { XBell(display_, 0); }
    // X has cursors of two colours: the third is drawn as the second.
    void show_image(const CursorImage& image, std::span<const std::uint32_t> colors) override {
        if (image.is_cross) {
            const ::Cursor cross = XCreateFontCursor(display_, XC_crosshair);
            XDefineCursor(display_, window_, cross);
            XFreeCursor(display_, cross);
            return;
        }
        const int row = image.size / 8;
        std::vector<char> front(std::size_t(row * image.size)), mask(front.size());
        for (int i = 0; i < image.size * image.size; ++i) {
            const int x = i % image.size, y = image.size - 1 - i / image.size;
            const int value = image.pixels[std::size_t(i)];
            const std::size_t at = std::size_t(y * row + x / 8);
            if (value == 1) front[at] = char(front[at] | 1 << x % 8);
            if (value != 0) mask[at] = char(mask[at] | 1 << x % 8);
        }
        const auto bitmap = [&](const std::vector<char>& bits) {
            return XCreateBitmapFromData(display_, window_, bits.data(), unsigned(image.size),
                                         unsigned(image.size));
        };
        const auto color = [](std::uint32_t c) {
            XColor out{};
            out.red = static_cast<unsigned short>((c & 0xFF) * 257);
            out.green = static_cast<unsigned short>((c >> 8 & 0xFF) * 257);
            out.blue = static_cast<unsigned short>((c >> 16 & 0xFF) * 257);
            return out;
        };
        XColor first = color(colors[1]), second = color(colors[2]);
        const Pixmap shape = bitmap(front), whole = bitmap(mask);
        const ::Cursor cursor =
            XCreatePixmapCursor(display_, shape, whole, &first, &second, unsigned(image.x),
                                unsigned(image.size - 1 - image.y));
        XDefineCursor(display_, window_, cursor);
        XFreeCursor(display_, cursor);
        XFreePixmap(display_, shape);
        XFreePixmap(display_, whole);
    }
    void show_cursor(bool on) override {
        if (on) {
            XUndefineCursor(display_, window_);
            return;
        }
        const char none[] = {0};
        const Pixmap empty = XCreateBitmapFromData(display_, window_, none, 1, 1);
        XColor black{};
        const ::Cursor cursor = XCreatePixmapCursor(display_, empty, empty, &black, &black, 0, 0);
        XDefineCursor(display_, window_, cursor);
        XFreeCursor(display_, cursor);
        XFreePixmap(display_, empty);
    }
    void poll(const HostListener& listener) override {
        while (XPending(display_) > 0) {
            XEvent event;
            XNextEvent(display_, &event);
            if (event.xany.window == window_) tell(listener, event);
        }
    }

private:
    int top_of(int y, int height) const {
        return DisplayHeight(display_, visual_.screen) - y - height;
    }
    void tell(const HostListener& listener, XEvent& event);
    void tell_key(const HostListener& listener, XKeyEvent& event);

    Display* const display_;
    const XVisualInfo visual_;
    Window window_ = 0;
    Atom deleted_ = 0;
    int height_ = 0;
    std::unique_ptr<ShownImage> image_;
};

void XWindow::tell_key(const HostListener& listener, XKeyEvent& event) {
    const bool down = event.type == KeyPress;
    if (const unsigned device = device_of(XLookupKeysym(&event, 0))) listener.button(device, down);
    char text[8] = {};
    const int length = XLookupString(&event, text, sizeof text, nullptr, nullptr);
    for (int i = 0; down && i < length; ++i)
        listener.character(static_cast<unsigned char>(text[i]));
}

void XWindow::tell(const HostListener& listener, XEvent& event) {
    switch (event.type) {
        case KeyPress:
        case KeyRelease: return tell_key(listener, event.xkey);
        case MotionNotify: return listener.pointer(event.xmotion.x, height_ - 1 - event.xmotion.y);
        case ButtonPress:
        case ButtonRelease: {
            listener.pointer(event.xbutton.x, height_ - 1 - event.xbutton.y);
            const unsigned number = event.xbutton.button;
            if (number < 1 || number > 3) return;
            return listener.button(number == 1   ? unsigned(LEFTMOUSE)
                                   : number == 2 ? unsigned(MIDDLEMOUSE)
                                                 : unsigned(RIGHTMOUSE),
                                   event.type == ButtonPress);
        }
        case ConfigureNotify:
            height_ = event.xconfigure.height;
            listener.size(event.xconfigure.width, event.xconfigure.height);
            return;
        case Expose:
            if (event.xexpose.count == 0) listener.exposed();
            return;
        case FocusIn: return listener.focused();
        case ClientMessage:
            if (Atom(event.xclient.data.l[0]) == deleted_) listener.closed();
            return;
    }
}

/// The program's connection; null: DISPLAY is not set, or nobody answers.
Display* connection() {
    static Display* const one = std::getenv("DISPLAY") != nullptr ? XOpenDisplay(nullptr) : nullptr;
    return one;
}

}  // namespace

void wait_for_screen(int milliseconds) {
    Display* const display = connection();
    if (milliseconds == 0 || XPending(display) > 0) return;
    pollfd wait{ConnectionNumber(display), POLLIN, 0};
    ::poll(&wait, 1, milliseconds);
}

std::unique_ptr<HostWindow> make_host_window(const std::string& title, int x, int y, int width,
                                             int height, bool has_border) {
    Display* const display = connection();
    if (display == nullptr) return nullptr;
    const auto visuals = true_color_visuals(display, DefaultScreen(display));
    if (visuals.empty()) return nullptr;
    return std::make_unique<XWindow>(display, visuals.front(), title, x, y, width, height,
                                     has_border);
}

}  // namespace gw::irisgl
