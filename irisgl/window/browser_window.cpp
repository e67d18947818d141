// Windows on a page: canvases that web/engine/programs/screen.js opens, and the events that it has
// kept. Compiled by Emscripten alone.
#include "irisgl/window/host_window.h"

#include <emscripten.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

// JavaScript. Has no operators that C++ lacks, for clang-format.
EM_JS(int, gw_open_window, (const char* title, int x, int y, int width, int height),
      { return Module.screen.open(UTF8ToString(title), x, y, width, height); });
EM_JS(void, gw_close_window, (int id), { Module.screen.close(id); });
EM_JS(void, gw_show_pixels, (int id, const void* pixels, int width, int height), {
    Module.screen.show(id, HEAPU8.subarray(pixels, pixels + 4 * width * height), width, height);
});
EM_JS(void, gw_name_window, (int id, const char* title),
      { Module.screen.name(id, UTF8ToString(title)); });
EM_JS(void, gw_show_cursor, (int id, int on), { Module.screen.cursor(id, Boolean(on)); });
EM_JS(void, gw_show_cursor_image, (int id, const void* pixels, int size, int x, int y), {
    Module.screen.cursorImage(id, HEAPU8.slice(pixels, pixels + 4 * size * size), size, x, y);
});
EM_JS(void, gw_ring, (), { Module.screen.ring(); });
EM_JS(int, gw_page_must_turn, (int milliseconds),
      { return Module.screen.mustTurn(milliseconds) ? 1 : 0; });
EM_ASYNC_JS(void, gw_turn_page, (int milliseconds), { await Module.screen.turn(milliseconds); });
// The next event of a window, as text in `code` and numbers in `values`; 0: there is none.
EM_JS(int, gw_next_event, (int id, char* code, int size, int* values), {
    const event = Module.screen.take(id);
    if (!event) return 0;
    stringToUTF8(event.code, code, size);
    HEAP32.set(event.values, values >> 2);
    return event.kind;
});

namespace gw::irisgl {

namespace {

/// As screen.js names them.
enum EventKind { Key = 1, Button, Pointer, Focus, Close };

/// [UI Events KeyboardEvent code Values], but letters and digits.
struct KeyCode {
    std::string_view code;
    unsigned device;
};
constexpr KeyCode key_codes[] = {{"Escape", ESCKEY},
                                 {"Enter", RETKEY},
                                 {"Backspace", BACKSPACEKEY},
                                 {"Delete", DELKEY},
                                 {"Space", SPACEKEY},
                                 {"ArrowLeft", LEFTARROWKEY},
                                 {"ArrowRight", RIGHTARROWKEY},
                                 {"ArrowUp", UPARROWKEY},
                                 {"ArrowDown", DOWNARROWKEY},
                                 {"ShiftLeft", LEFTSHIFTKEY},
                                 {"ShiftRight", RIGHTSHIFTKEY},
                                 {"ControlLeft", LEFTCTRLKEY},
                                 {"ControlRight", RIGHTCTRLKEY},
                                 {"AltLeft", LEFTALTKEY},
                                 {"AltRight", RIGHTALTKEY},
                                 {"Minus", MINUSKEY},
                                 {"Equal", EQUALKEY},
                                 {"Comma", COMMAKEY},
                                 {"Period", PERIODKEY},
                                 {"Slash", VIRGULEKEY},
                                 {"Semicolon", SEMICOLONKEY},
                                 {"Quote", QUOTEKEY},
                                 {"BracketLeft", LEFTBRACKETKEY},
                                 {"BracketRight", RIGHTBRACKETKEY},
                                 {"Backslash", BACKSLASHKEY},
                                 {"Home", HOMEKEY},
                                 {"End", ENDKEY},
                                 {"PageUp", PAGEUPKEY},
                                 {"PageDown", PAGEDOWNKEY},
                                 {"Insert", INSERTKEY},
                                 {"NumpadEnter", PADENTER},
                                 {"Numpad0", PAD0},
                                 {"Numpad1", PAD1},
                                 {"Numpad2", PAD2},
                                 {"Numpad3", PAD3},
                                 {"Numpad4", PAD4},
                                 {"Numpad5", PAD5},
                                 {"Numpad6", PAD6},
                                 {"Numpad7", PAD7},
                                 {"Numpad8", PAD8},
                                 {"Numpad9", PAD9},
                                 {"F1", F1KEY},
                                 {"F2", F2KEY},
                                 {"F3", F3KEY},
                                 {"F4", F4KEY},
                                 {"F5", F5KEY},
                                 {"F6", F6KEY},
                                 {"F7", F7KEY},
                                 {"F8", F8KEY},
                                 {"F9", F9KEY},
                                 {"F10", F10KEY},
                                 {"F11", F11KEY},
                                 {"F12", F12KEY}};

unsigned device_of(std::string_view code) {
    if (code.size() == 4 && code.starts_with("Key") && code[3] >= 'A' && code[3] <= 'Z')
        return letter_keys[std::size_t(code[3] - 'A')];
    if (code.size() == 6 && code.starts_with("Digit") && code[5] >= '0' && code[5] <= '9')
        return digit_keys[std::size_t(code[5] - '0')];
    for (const KeyCode& key : key_codes)
        if (key.code == code) return key.device;
    return 0;
}

class BrowserWindow : public HostWindow {
public:
    BrowserWindow(const std::string& title, int x, int y, int width, int height)
        : id_(gw_open_window(title.c_str(), x, y, width, height)) {}
    ~BrowserWindow() override { gw_close_window(id_); }

    void show(std::span<const std::uint32_t> pixels, int width, int height) override {
        gw_show_pixels(id_, pixels.data(), width, height);
    }
    void set_title(const std::string& title) override { gw_name_window(id_, title.c_str()); }
    void place(int, int, int, int) override {}  // the page arranges its windows
    void raise(bool) override {}
    void ring() override { gw_ring(); }
    void show_cursor(bool on) override { gw_show_cursor(id_, on); }
    void show_image(const CursorImage& image, std::span<const std::uint32_t> colors) override {
        if (image.is_cross) return gw_show_cursor_image(id_, nullptr, 0, 0, 0);
        std::vector<std::uint32_t> pixels;
        for (const std::uint8_t value : image.pixels)
            pixels.push_back(value == 0 ? 0 : colors[value] | 0xFF000000u);
        gw_show_cursor_image(id_, pixels.data(), image.size, image.x, image.y);
    }

    void poll(const HostListener& listener) override {
        std::array<char, 32> code{};
        std::array<int, 4> values{};
        while (const int kind = gw_next_event(id_, code.data(), int(code.size()), values.data()))
            tell(listener, kind, code.data(), values);
    }

private:
    static void tell(const HostListener& listener, int kind, std::string_view code,
                     const std::array<int, 4>& values) {
        switch (kind) {
            case Key:
                if (const unsigned device = device_of(code)) listener.button(device, values[0]);
                if (values[1] != 0) listener.character(static_cast<unsigned char>(values[1]));
                return;
            case Button: {
                constexpr std::array<unsigned, 3> buttons{LEFTMOUSE, MIDDLEMOUSE, RIGHTMOUSE};
                listener.pointer(values[2], values[3]);
                if (values[1] < 3) listener.button(buttons[std::size_t(values[1])], values[0]);
                return;
            }
            case Pointer: return listener.pointer(values[2], values[3]);
            case Focus: return listener.focused();
            case Close: return listener.closed();
        }
    }

    const int id_;
};

}  // namespace

void wait_for_screen(int milliseconds) {
    if (gw_page_must_turn(milliseconds)) gw_turn_page(milliseconds);
}

/// Null: no page, as under Node.
std::unique_ptr<HostWindow> make_host_window(const std::string& title, int x, int y, int width,
                                             int height, bool) {
    if (EM_ASM_INT({ return Module.screen ? 1 : 0; }) == 0) return nullptr;
    return std::make_unique<BrowserWindow>(title, x, y, width, height);
}

}  // namespace gw::irisgl
