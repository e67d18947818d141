// The file of GW_INPUT: events for programs without a hand at the mouse.
#include "irisgl/state/events.h"

#include "gw/escape_controls.h"

#include "irisgl/state/tokens.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace gw::irisgl {

namespace {

struct DeviceName {
    const char* name;
    unsigned device;
};
constexpr DeviceName device_names[] = {{"BUT0", BUT0},
                                       {"BREAKKEY", BREAKKEY},
                                       {"SETUPKEY", SETUPKEY},
                                       {"LEFTCTRLKEY", LEFTCTRLKEY},
                                       {"CTRLKEY", CTRLKEY},
                                       {"CAPSLOCKKEY", CAPSLOCKKEY},
                                       {"RIGHTSHIFTKEY", RIGHTSHIFTKEY},
                                       {"LEFTSHIFTKEY", LEFTSHIFTKEY},
                                       {"ESCKEY", ESCKEY},
                                       {"ONEKEY", ONEKEY},
                                       {"TABKEY", TABKEY},
                                       {"QKEY", QKEY},
                                       {"AKEY", AKEY},
                                       {"SKEY", SKEY},
                                       {"NOSCRLKEY", NOSCRLKEY},
                                       {"TWOKEY", TWOKEY},
                                       {"THREEKEY", THREEKEY},
                                       {"WKEY", WKEY},
                                       {"EKEY", EKEY},
                                       {"DKEY", DKEY},
                                       {"FKEY", FKEY},
                                       {"ZKEY", ZKEY},
                                       {"XKEY", XKEY},
                                       {"FOURKEY", FOURKEY},
                                       {"FIVEKEY", FIVEKEY},
                                       {"RKEY", RKEY},
                                       {"TKEY", TKEY},
                                       {"GKEY", GKEY},
                                       {"HKEY", HKEY},
                                       {"CKEY", CKEY},
                                       {"VKEY", VKEY},
                                       {"SIXKEY", SIXKEY},
                                       {"SEVENKEY", SEVENKEY},
                                       {"YKEY", YKEY},
                                       {"UKEY", UKEY},
                                       {"JKEY", JKEY},
                                       {"KKEY", KKEY},
                                       {"BKEY", BKEY},
                                       {"NKEY", NKEY},
                                       {"EIGHTKEY", EIGHTKEY},
                                       {"NINEKEY", NINEKEY},
                                       {"IKEY", IKEY},
                                       {"OKEY", OKEY},
                                       {"LKEY", LKEY},
                                       {"SEMICOLONKEY", SEMICOLONKEY},
                                       {"MKEY", MKEY},
                                       {"COMMAKEY", COMMAKEY},
                                       {"ZEROKEY", ZEROKEY},
                                       {"MINUSKEY", MINUSKEY},
                                       {"PKEY", PKEY},
                                       {"LEFTBRACKETKEY", LEFTBRACKETKEY},
                                       {"QUOTEKEY", QUOTEKEY},
                                       {"RETKEY", RETKEY},
                                       {"PERIODKEY", PERIODKEY},
                                       {"VIRGULEKEY", VIRGULEKEY},
                                       {"ACCENTGRAVEKEY", ACCENTGRAVEKEY},
                                       {"EQUALKEY", EQUALKEY},
                                       {"RIGHTBRACKETKEY", RIGHTBRACKETKEY},
                                       {"BACKSLASHKEY", BACKSLASHKEY},
                                       {"PAD1", PAD1},
                                       {"PAD0", PAD0},
                                       {"LINEFEEDKEY", LINEFEEDKEY},
                                       {"BACKSPACEKEY", BACKSPACEKEY},
                                       {"DELKEY", DELKEY},
                                       {"PAD4", PAD4},
                                       {"PAD2", PAD2},
                                       {"PAD3", PAD3},
                                       {"PADPERIOD", PADPERIOD},
                                       {"PAD7", PAD7},
                                       {"PAD8", PAD8},
                                       {"PAD5", PAD5},
                                       {"PAD6", PAD6},
                                       {"LEFTARROWKEY", LEFTARROWKEY},
                                       {"DOWNARROWKEY", DOWNARROWKEY},
                                       {"PAD9", PAD9},
                                       {"PADMINUS", PADMINUS},
                                       {"PADCOMMA", PADCOMMA},
                                       {"RIGHTARROWKEY", RIGHTARROWKEY},
                                       {"UPARROWKEY", UPARROWKEY},
                                       {"PADENTER", PADENTER},
                                       {"SPACEKEY", SPACEKEY},
                                       {"LEFTALTKEY", LEFTALTKEY},
                                       {"RIGHTALTKEY", RIGHTALTKEY},
                                       {"RIGHTCTRLKEY", RIGHTCTRLKEY},
                                       {"F1KEY", F1KEY},
                                       {"F2KEY", F2KEY},
                                       {"F3KEY", F3KEY},
                                       {"F4KEY", F4KEY},
                                       {"F5KEY", F5KEY},
                                       {"F6KEY", F6KEY},
                                       {"F7KEY", F7KEY},
                                       {"F8KEY", F8KEY},
                                       {"F9KEY", F9KEY},
                                       {"F10KEY", F10KEY},
                                       {"F11KEY", F11KEY},
                                       {"F12KEY", F12KEY},
                                       {"PRINTSCREENKEY", PRINTSCREENKEY},
                                       {"INSERTKEY", INSERTKEY},
                                       {"HOMEKEY", HOMEKEY},
                                       {"PAGEUPKEY", PAGEUPKEY},
                                       {"ENDKEY", ENDKEY},
                                       {"PAGEDOWNKEY", PAGEDOWNKEY},
                                       {"RIGHTMOUSE", RIGHTMOUSE},
                                       {"MOUSE1", MOUSE1},
                                       {"MIDDLEMOUSE", MIDDLEMOUSE},
                                       {"MOUSE2", MOUSE2},
                                       {"LEFTMOUSE", LEFTMOUSE},
                                       {"MOUSE3", MOUSE3},
                                       {"MENUBUTTON", MENUBUTTON},
                                       {"LPENBUT", LPENBUT},
                                       {"SW0", SW0},
                                       {"DIAL0", DIAL0},
                                       {"DIAL1", DIAL1},
                                       {"DIAL2", DIAL2},
                                       {"DIAL3", DIAL3},
                                       {"DIAL4", DIAL4},
                                       {"DIAL5", DIAL5},
                                       {"DIAL6", DIAL6},
                                       {"DIAL7", DIAL7},
                                       {"DIAL8", DIAL8},
                                       {"MOUSEX", MOUSEX},
                                       {"MOUSEY", MOUSEY},
                                       {"CURSORX", CURSORX},
                                       {"CURSORY", CURSORY},
                                       {"TIMER0", TIMER0},
                                       {"TIMER1", TIMER1},
                                       {"TIMER2", TIMER2},
                                       {"TIMER3", TIMER3},
                                       {"KEYBD", KEYBD},
                                       {"RAWKEYBD", RAWKEYBD},
                                       {"GHOSTX", GHOSTX},
                                       {"GHOSTY", GHOSTY},
                                       {"REDRAW", REDRAW},
                                       {"MODECHANGE", MODECHANGE},
                                       {"INPUTCHANGE", INPUTCHANGE},
                                       {"QFULL", QFULL},
                                       {"PIECECHANGE", PIECECHANGE},
                                       {"WINCLOSE", WINCLOSE},
                                       {"QREADERROR", QREADERROR},
                                       {"WINFREEZE", WINFREEZE},
                                       {"WINTHAW", WINTHAW},
                                       {"REDRAWICONIC", REDRAWICONIC},
                                       {"WINQUIT", WINQUIT},
                                       {"DEPTHCHANGE", DEPTHCHANGE},
                                       {"WINSHUT", WINSHUT},
                                       {"DRAWKEY", DRAWKEY}};

bool read_value(const std::string& word, unsigned device, long& value) {
    if (word == "down" || word == "up") {
        value = word == "down" ? 1 : 0;
        return true;
    }
    if (device == KEYBD && word.size() == 1) {
        value = static_cast<unsigned char>(word[0]);
        return true;
    }
    char* end = nullptr;
    value = std::strtol(word.c_str(), &end, 10);
    return end != word.c_str() && *end == '\0';
}

bool read_line(const std::string& line, ScriptedEvent& out) {
    std::istringstream in(line);
    std::string frame, device, value;
    if (!(in >> frame >> out.frame >> device >> value) || frame != "frame") return false;
    out.event.device = device_named(device);
    if (out.event.device == 0 || !read_value(value, out.event.device, out.event.value))
        return false;
    out.has_place = bool(in >> out.x);
    if (out.has_place && !(in >> out.y)) return false;
    in.clear();
    return !(in >> value);
}

}  // namespace

unsigned device_named(const std::string& name) {
    for (const DeviceName& d : device_names)
        if (name == d.name) return d.device;
    return 0;
}

std::deque<ScriptedEvent> read_script() {
    std::deque<ScriptedEvent> out;
    const char* const file = std::getenv("GW_INPUT");
    if (file == nullptr) return out;
    std::ifstream in(file);
    if (!in) std::fprintf(stderr, "gw: GW_INPUT: %s: cannot be read\n", file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
        ScriptedEvent event;
        if (read_line(line, event))
            out.push_back(event);
        else
            std::fprintf(
                stderr,
                "gw: %s:%d: '%s'; expected a line like 'frame 3 LEFTMOUSE down 100 200'; it is "
                "left out\n",
                file, number, escape_controls(line).c_str());
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.frame < b.frame; });
    return out;
}

}  // namespace gw::irisgl
