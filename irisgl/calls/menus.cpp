// Pop-up menus: definitions with their % words, and their choice by mouse, keys or queued events.
#include "irisgl/calls/run.h"
#include "irisgl/calls/shared.h"
#include "irisgl/draw/screen_font.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <cstdarg>
#include <cstdlib>
#include <deque>
#include <set>
#include <string>
#include <utility>

namespace gw::irisgl {

namespace {

using MenuFunction = long (*)(long);
constexpr int row_height = 18, margin = 8;

/// The words after % of an entry "text%x3": the arguments that some take come from `next`.
void apply_word(Menu& menu, MenuEntry& entry, const std::string& word, bool& is_title,
                va_list& next) {
    const char kind = word.empty() ? '\0' : word[0];
    const long number =
        std::strtol(word.c_str() + std::min<std::size_t>(word.size(), 1), nullptr, 10);
    if (kind == 't') is_title = true;
    if (kind == 'x') entry.value = number;
    if (kind == 'l') entry.is_line_after = true;
    if (kind == 'f' || kind == 'n') entry.function = va_arg(next, MenuFunction);
    if (kind == 'n') entry.ignores_menu = true;
    if (kind == 'F') menu.function = va_arg(next, MenuFunction);
    if (kind == 'm') entry.submenu = va_arg(next, int);
}

void add_entry(Menu& menu, const std::string& text, va_list& next) {
    MenuEntry entry;
    entry.value = long(menu.entries.size()) + 1;
    bool is_title = false;
    std::size_t at = text.find('%');
    entry.text = text.substr(0, at);
    while (at != std::string::npos) {
        const std::size_t end = text.find('%', at + 1);
        apply_word(menu, entry, text.substr(at + 1, end == std::string::npos ? end : end - at - 1),
                   is_title, next);
        at = end;
    }
    if (is_title)
        menu.title = entry.text;
    else
        menu.entries.push_back(entry);
}

void add_entries(Menu& menu, const std::string& text, va_list& next) {
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t bar = std::min(text.find('|', from), text.size());
        add_entry(menu, text.substr(from, bar - from), next);
        from = bar + 1;
    }
}

/// An open menu in the pop-up planes.
struct OpenMenu {
    const Menu& menu;
    int x, y, width, height;  ///< its lower left
    int chosen = -1;
    int header() const { return menu.title.empty() ? 0 : row_height; }
    int row_y(int i) const { return y + height - header() - (i + 1) * row_height; }
};

void fill(PopupPlanes& planes, int x, int y, int w, int h, std::uint8_t value) {
    for (int row = std::max(y, 0); row < std::min(y + h, planes.height); ++row)
        for (int column = std::max(x, 0); column < std::min(x + w, planes.width); ++column)
            planes.pixels[std::size_t(row) * std::size_t(planes.width) + std::size_t(column)] =
                value;
}

void write(PopupPlanes& planes, int x, int y, const std::string& text, std::uint8_t value) {
    static const Font& font = *new Font(screen_font());
    for (const char c : text) {
        const std::size_t i = static_cast<unsigned char>(c);
        if (i >= font.glyphs.size()) continue;
        const Glyph& g = font.glyphs[i];
        for (int row = 0; row < g.h; ++row)
            for (int bit = 0; bit < g.w; ++bit)
                if ((g.rows[std::size_t(row)] >> (15 - bit) & 1) != 0)
                    fill(planes, x + g.xoff + bit, y + row, 1, 1, value);
        x += g.width;
    }
}

void paint(PopupPlanes& planes, const OpenMenu& m) {
    planes.is_used = true;
    fill(planes, m.x - 1, m.y - 1, m.width + 2, m.height + 2, PUP_BLACK);
    fill(planes, m.x, m.y, m.width, m.height, PUP_COLOR);
    if (!m.menu.title.empty()) {
        fill(planes, m.x, m.y + m.height - row_height, m.width, row_height, PUP_BLACK);
        write(planes, m.x + margin, m.y + m.height - row_height + 4, m.menu.title, PUP_WHITE);
    }
    for (int i = 0; i < int(m.menu.entries.size()); ++i) {
        const MenuEntry& e = m.menu.entries[std::size_t(i)];
        const int y = m.row_y(i);
        if (i == m.chosen) fill(planes, m.x, y, m.width, row_height, PUP_WHITE);
        write(planes, m.x + margin, y + 4, e.mark + e.text + (e.submenu != 0 ? " >" : ""),
              PUP_BLACK);
        if (e.is_line_after) fill(planes, m.x, y, m.width, 1, PUP_BLACK);
    }
}

OpenMenu opened(const Menu& menu, int x, int top) {
    std::size_t letters = menu.title.size();
    for (const MenuEntry& e : menu.entries)
        letters = std::max(letters, e.mark.size() + e.text.size() + 2);
    OpenMenu m{menu, x, 0, int(letters) * 9 + 2 * margin, 0};
    m.height = m.header() + int(menu.entries.size()) * row_height;
    m.y = top - m.height;
    return m;
}

int entry_at(const OpenMenu& m, int x, int y) {
    if (x < m.x || x >= m.x + m.width) return -1;
    const int row = (m.y + m.height - m.header() - 1 - y);
    if (row < 0 || y < m.y) return -1;
    return std::min(row / row_height, int(m.menu.entries.size()) - 1);
}

long result_of(const Menu& menu, const MenuEntry& entry) {
    long value = entry.value;
    if (entry.function != nullptr) value = entry.function(value);
    if (menu.function != nullptr && !entry.ignores_menu) value = menu.function(value);
    return value;
}

/// The queue while a menu is open: mouse and keys are its own. They come back as they were.
class MenuDevices {
public:
    MenuDevices()
        : kept_(program().events.queued), before_(std::exchange(program().events.queue, {})) {
        for (const unsigned d : {RIGHTMOUSE, MIDDLEMOUSE, LEFTMOUSE, MOUSEX, MOUSEY, UPARROWKEY,
                                 DOWNARROWKEY, RETKEY, ESCKEY})
            program().events.queued.insert(d);
        // What the program has queued already may choose.
        for (const Event& e : before_)
            (is_of_menu(e.device) ? program().events.queue : left_).push_back(e);
    }
    ~MenuDevices() {
        program().events.queued = kept_;
        program().events.queue = left_;
    }
    MenuDevices(const MenuDevices&) = delete;
    MenuDevices& operator=(const MenuDevices&) = delete;
    static bool is_of_menu(unsigned d) {
        return d == RIGHTMOUSE || d == MIDDLEMOUSE || d == LEFTMOUSE || d == MOUSEX ||
               d == MOUSEY || d == UPARROWKEY || d == DOWNARROWKEY || d == RETKEY || d == ESCKEY;
    }
    /// Any other event waits for the program.
    void leave(const Event& e) { left_.push_back(e); }

private:
    std::set<unsigned> kept_;
    std::deque<Event> before_, left_;
};

/// Whether any further event can come: without a screen, only the script's.
bool can_wait() {
    const Events& e = program().events;
    return !e.queue.empty() || !e.script.empty() || current_window().host() != nullptr;
}

bool is_button(unsigned device) { return device == RIGHTMOUSE || device == LEFTMOUSE; }

/// Whether the program opens a menu because a button was pressed. By now it may be up again.
bool follows_press() {
    const Event& last = program().events.taken;
    return is_button(last.device) && last.value != 0;
}

/// The entry that is chosen; null: none.
const MenuEntry* choose(OpenMenu& m, MenuDevices& devices) {
    Window& w = current_window();
    bool has_pressed = follows_press() || program().events.down.contains(RIGHTMOUSE);
    for (;;) {
        paint(w.popup, m);
        w.show_again();
        poll(false);
        if (program().events.queue.empty()) {
            if (!can_wait()) return nullptr;
            poll(true);
        }
        const Event e = take();
        const int count = int(m.menu.entries.size());
        if (e.device == MOUSEX || e.device == MOUSEY || is_button(e.device)) {
            m.chosen = entry_at(m, e.x - w.x, e.y - w.y);
            if (is_button(e.device) && e.value == 0 && has_pressed)
                return m.chosen >= 0 ? &m.menu.entries[std::size_t(m.chosen)] : nullptr;
            has_pressed |= is_button(e.device);
        } else if (e.device == UPARROWKEY && e.value != 0) {
            m.chosen = m.chosen <= 0 ? count - 1 : m.chosen - 1;
        } else if (e.device == DOWNARROWKEY && e.value != 0) {
            m.chosen = (m.chosen + 1) % std::max(count, 1);
        } else if (e.device == RETKEY && e.value != 0) {
            return m.chosen >= 0 ? &m.menu.entries[std::size_t(m.chosen)] : nullptr;
        } else if (e.device == ESCKEY && e.value != 0) {
            return nullptr;
        } else if (!MenuDevices::is_of_menu(e.device)) {
            devices.leave(e);
        }
    }
}

long run_menu(long number, int x, int top, MenuDevices& devices, int depth) {
    const auto found = program().menus.all.find(number);
    if (found == program().menus.all.end() || depth > 16) return -1;
    OpenMenu m = opened(found->second, x, top);
    if (m.y < 0) m.y = 0;
    const MenuEntry* const entry = choose(m, devices);
    if (entry == nullptr || entry->is_grey) return -1;
    if (entry->submenu == 0) return result_of(found->second, *entry);
    const long value =
        run_menu(entry->submenu, m.x + m.width, m.row_y(m.chosen) + row_height, devices, depth + 1);
    return value >= 0 && found->second.function != nullptr ? found->second.function(value) : value;
}

}  // namespace

namespace calls {

long newpup() {
    const long number = program().menus.next++;
    program().menus.all[number];
    return number;
}

void freepup(long menu) { program().menus.all.erase(menu); }

long dopup(long menu) {
    if (program().current == nullptr || !program().menus.all.contains(menu)) {
        warn("dopup: menu " + std::to_string(menu) +
             " is not defined, or no window is open; it returns -1");
        return -1;
    }
    Window& w = current_window();
    w.popup.fit(w.width(), w.height());
    long value = -1;
    {
        MenuDevices devices;
        const Event& last = program().events.taken;
        const auto at = [](unsigned d) { return int(program().events.valuators[d].value); };
        const int x = follows_press() ? last.x : at(MOUSEX),
                  y = follows_press() ? last.y : at(MOUSEY);
        value = run_menu(menu, x - w.x, y - w.y, devices, 0);
    }
    w.popup.clear();
    w.show_again();
    return value;
}

void setpup(long menu, long entry, unsigned long mode) {
    const auto found = program().menus.all.find(menu);
    if (found == program().menus.all.end() || entry < 1 ||
        entry > long(found->second.entries.size()))
        return warn("setpup: the menu has no entry " + std::to_string(entry) + "; it is ignored");
    found->second.entries[std::size_t(entry - 1)].is_grey = (mode & PUP_GREY) != 0;
    found->second.entries[std::size_t(entry - 1)].mark = (mode & PUP_CHECK) != 0 ? "[x] "
                                                         : (mode & PUP_BOX) != 0 ? "[ ] "
                                                                                 : "";
}

}  // namespace calls
}  // namespace gw::irisgl

#pragma GCC visibility push(default)
extern "C" {

long defpup(const char* text, ...) {
    using namespace gw::irisgl;
    const long number = calls::newpup();
    va_list next;
    va_start(next, text);
    add_entries(program().menus.all[number], text != nullptr ? text : "", next);
    va_end(next);
    return number;
}

void addtopup(long menu, const char* text, ...) {
    using namespace gw::irisgl;
    const auto found = program().menus.all.find(menu);
    if (found == program().menus.all.end())
        return warn("addtopup: menu " + std::to_string(menu) + " is not defined; it is ignored");
    va_list next;
    va_start(next, text);
    add_entries(found->second, text != nullptr ? text : "", next);
    va_end(next);
}

}  // extern "C"
#pragma GCC visibility pop
