// Pop-up menus as data.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gw::irisgl {

struct MenuEntry {
    std::string text;
    long value = 0;
    long (*function)(long) = nullptr;  ///< %f, %n
    long submenu = 0;                  ///< %m
    bool is_line_after = false;        ///< %l
    bool is_grey = false;              ///< setpup
    bool ignores_menu = false;         ///< %n: the menu's function is not called
    std::string mark;                  ///< setpup: "[ ] " or "[x] " before the text
};

struct Menu {
    std::string title;
    std::vector<MenuEntry> entries;
    long (*function)(long) = nullptr;  ///< %F
};

struct Menus {
    std::map<long, Menu> all;
    long next = 1;
};

}  // namespace gw::irisgl
