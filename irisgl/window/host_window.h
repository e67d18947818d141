// A window on a screen: X11, or none. Does not know the machine.
#pragma once

#include "irisgl/include/gl/device.h"
#include "irisgl/state/cursor_image.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace gw::irisgl {

/// What a screen tells. Places are pixels of the window, from its lower left.
struct HostListener {
    std::function<void(unsigned device, bool down)> button;
    std::function<void(unsigned char character)> character;
    std::function<void(int x, int y)> pointer;
    std::function<void(int width, int height)> size;
    std::function<void(int x, int y)> place;
    std::function<void()> exposed, focused, closed;
};

class HostWindow {
public:
    virtual ~HostWindow() = default;
    /// R lowest, bottom row first.
    virtual void show(std::span<const std::uint32_t> pixels, int width, int height) = 0;
    virtual void set_title(const std::string& title) = 0;
    virtual void place(int x, int y, int width, int height) = 0;
    virtual void raise(bool up) = 0;
    virtual void ring() = 0;
    virtual void show_cursor(bool on) = 0;
    /// A cursor of the program's, with the colours of its pixels' values 1 to 3.
    virtual void show_image(const CursorImage& image, std::span<const std::uint32_t> colors) = 0;
    /// Tells what has happened.
    virtual void poll(const HostListener& listener) = 0;
};

/// Waits until something happens on the screen, for up to `milliseconds`. A page's browser works
/// meanwhile, so nothing may stand between the program and this but direct calls.
void wait_for_screen(int milliseconds);

/// Null: no screen. `y` is of the lower row, from the bottom of the screen.
std::unique_ptr<HostWindow> make_host_window(const std::string& title, int x, int y, int width,
                                             int height, bool has_border);

/// The devices of the keys of letters and digits.
inline constexpr unsigned letter_keys[] = {AKEY, BKEY, CKEY, DKEY, EKEY, FKEY, GKEY, HKEY, IKEY,
                                           JKEY, KKEY, LKEY, MKEY, NKEY, OKEY, PKEY, QKEY, RKEY,
                                           SKEY, TKEY, UKEY, VKEY, WKEY, XKEY, YKEY, ZKEY};
inline constexpr unsigned digit_keys[] = {ZEROKEY, ONEKEY, TWOKEY,   THREEKEY, FOURKEY,
                                          FIVEKEY, SIXKEY, SEVENKEY, EIGHTKEY, NINEKEY};

}  // namespace gw::irisgl
