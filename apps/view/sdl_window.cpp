// The module libgw_window.so: a window by SDL2.
#include "apps/view/window.h"
#include "gw/error.h"
#include "gw/planes.h"

#include <SDL2/SDL.h>

#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

namespace gw::apps {
namespace {

struct Closer {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};
template <class T>
using Owned = std::unique_ptr<T, Closer>;

[[noreturn]] void fail(const std::string& what) {
    throw Error("gw view: " + what + ": " + SDL_GetError() +
                "; expected a display (DISPLAY or WAYLAND_DISPLAY); gw render needs none");
}

class Library {
public:
    Library() {
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        // The picture is in memory; OpenGL would only make the window anew.
        SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
        choose_display();
        if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window");
    }
    ~Library() { SDL_Quit(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

private:
    /// Else SDL takes a driver without a screen when there is no display.
    static void choose_display() {
        const auto is_set = [](const char* name) {
            const char* value = std::getenv(name);
            return value != nullptr && *value != 0;
        };
        if (is_set("SDL_VIDEODRIVER")) return;
        if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) {
            SDL_SetError("no display is set");
            fail("no window");
        }
        SDL_SetHint(SDL_HINT_VIDEODRIVER, is_set("WAYLAND_DISPLAY") ? "wayland,x11" : "x11");
    }
};

/// Keys that are no characters.
std::string name_of(SDL_Keycode key) {
    switch (key) {
        case SDLK_LEFT: return "Left";
        case SDLK_RIGHT: return "Right";
        case SDLK_UP: return "Up";
        case SDLK_DOWN: return "Down";
        case SDLK_TAB: return "Tab";
        case SDLK_HOME: return "Home";
        case SDLK_ESCAPE: return "Escape";
        case SDLK_SPACE: return "Space";
        default: return "";
    }
}

Input mouse_input(Input::Kind kind, int x, int y, int button) {
    const SDL_Keymod keys = SDL_GetModState();
    return {.kind = kind,
            .x = x,
            .y = y,
            .button = button,
            .shift = (keys & KMOD_SHIFT) != 0,
            .ctrl = (keys & KMOD_CTRL) != 0};
}

std::optional<Input> input_of(const SDL_Event& event) {
    using Kind = Input::Kind;
    switch (event.type) {
        case SDL_QUIT: return Input{.kind = Kind::Close};
        case SDL_KEYDOWN: {
            const std::string name = name_of(event.key.keysym.sym);
            if (name.empty()) return {};
            return Input{.kind = Kind::Key, .key = name};
        }
        case SDL_TEXTINPUT:
            if (event.text.text[0] == ' ') return {};
            return Input{.kind = Kind::Key, .key = event.text.text};
        case SDL_MOUSEBUTTONDOWN:
            SDL_CaptureMouse(SDL_TRUE);
            return mouse_input(Kind::Press, event.button.x, event.button.y, event.button.button);
        case SDL_MOUSEBUTTONUP:
            SDL_CaptureMouse(SDL_FALSE);
            return mouse_input(Kind::Release, event.button.x, event.button.y, event.button.button);
        case SDL_MOUSEMOTION: return mouse_input(Kind::Move, event.motion.x, event.motion.y, 0);
        case SDL_MOUSEWHEEL: return Input{.kind = Kind::Wheel, .wheel = double(event.wheel.y)};
        default: return {};
    }
}

class SdlWindow final : public Window {
public:
    SdlWindow(const std::string& title, int width, int height)
        : width_(width),
          height_(height),
          window_(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   width, height, SDL_WINDOW_RESIZABLE)) {
        if (!window_) fail("no window");
        renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE));
        if (!renderer_) fail("no picture in the window");
        SDL_RenderSetLogicalSize(renderer_.get(), width, height);
        texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888,
                                         SDL_TEXTUREACCESS_STREAMING, width, height));
        if (!texture_) fail("no picture in the window");
        SDL_StartTextInput();
    }

    void show(const image::Picture& screen) override {
        words_.resize(std::size_t(width_) * std::size_t(height_));
        for (int y = 0; y < height_; ++y) {
            const std::uint16_t* from = &screen.values[3 * pixel_index(0, height_ - 1 - y, width_)];
            std::uint32_t* to = &words_[pixel_index(0, y, width_)];
            for (int x = 0; x < width_; ++x, from += 3)
                to[x] = std::uint32_t(from[0]) << 16 | std::uint32_t(from[1]) << 8 | from[2];
        }
        SDL_UpdateTexture(texture_.get(), nullptr, words_.data(), 4 * width_);
        present();
    }
    /// Asks again and again. SDL_WaitEventTimeout would send each event's window a message by a
    /// second connection: if that comes after the window is gone, BadWindow ends the program.
    std::optional<Input> next_input(std::chrono::milliseconds wait) override {
        const auto end = std::chrono::steady_clock::now() + wait;
        while (true) {
            SDL_Event event;
            while (SDL_PollEvent(&event) != 0) {
                if (event.type == SDL_WINDOWEVENT) present();
                if (auto input = input_of(event)) return input;
            }
            if (std::chrono::steady_clock::now() >= end) return {};
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

private:
    void present() {
        SDL_RenderClear(renderer_.get());
        SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr);
        SDL_RenderPresent(renderer_.get());
    }

    const Library library_;
    int width_, height_;
    Owned<SDL_Window> window_;
    Owned<SDL_Renderer> renderer_;
    Owned<SDL_Texture> texture_;
    std::vector<std::uint32_t> words_;  ///< 0, R, G, B, the top row first
};

std::unique_ptr<Window> open_sdl_window(const std::string& title, int width, int height) {
    return std::make_unique<SdlWindow>(title, width, height);
}

}  // namespace

extern "C" {
/// The module's only symbol.
[[gnu::visibility("default")]] extern const OpenWindow gw_open_window;
const OpenWindow gw_open_window = open_sdl_window;
}

}  // namespace gw::apps
