// Cursors, menus, events, windows.
#include "tests/irisgl/support.h"

#include <vector>

namespace gw::irisgl {

using IrisGlDevices = IrisGl;

TEST_F(IrisGlDevices, TheQueueKeepsWhatTheProgramEnters) {
    short value = 0, data[6] = {};
    qenter(0x1234, -5);
    EXPECT_EQ(qtest(), 0x1234);
    EXPECT_EQ(qread(&value), 0x1234);
    EXPECT_EQ(value, -5);
    for (short i = 0; i < 4; ++i) qenter(REDRAW, i);
    EXPECT_EQ(blkqread(data, 5), 4);  // two entries of two numbers
    EXPECT_EQ(data[0], REDRAW);
    EXPECT_EQ(data[3], 1);
    qreset();
    EXPECT_EQ(qtest(), 0);
    EXPECT_FALSE(isqueued(AKEY));
    qdevice(AKEY);
    EXPECT_TRUE(isqueued(AKEY));
    unqdevice(AKEY);
    EXPECT_FALSE(isqueued(AKEY));
}

TEST_F(IrisGlDevices, NoiseHoldsBackSmallMoves) {
    qdevice(MOUSEX);
    setvaluator(MOUSEX, 100, 0, 1279);
    noise(MOUSEX, 5);
    happen(MOUSEX, 103);
    EXPECT_EQ(qtest(), 0);
    EXPECT_EQ(getvaluator(MOUSEX), 103);
    happen(MOUSEX, 105);
    EXPECT_EQ(qtest(), MOUSEX);
    noise(MOUSEX, 1);
}

TEST_F(IrisGlDevices, ValuatorsStayInTheirRange) {
    setvaluator(MOUSEX, 900, 0, 500);
    EXPECT_EQ(getvaluator(MOUSEX), 500);
    happen(MOUSEX, -3);
    EXPECT_EQ(getvaluator(MOUSEX), 0);
    setvaluator(MOUSEX, 5, 10, 0);
    EXPECT_EQ(getvaluator(MOUSEX), 0);
    EXPECT_EQ(getvaluator(AKEY), -1);
    unsigned short devices[] = {MOUSEX, LEFTMOUSE};
    short values[2] = {-1, -1};
    happen(LEFTMOUSE, 1);
    getdev(2, devices, values);
    EXPECT_EQ(values[0], 0);
    EXPECT_EQ(values[1], 1);
}

long doubled(long value) { return 2 * value; }
long plus_hundred(long value) { return 100 + value; }

class IrisGlMenus : public IrisGl {
protected:
    /// The answer if the pointer goes down `steps` times, then the entry is taken.
    static long chosen(long menu, int steps) {
        for (int i = 0; i < steps; ++i) enter(DOWNARROWKEY, 1);
        enter(RETKEY, 1);
        return dopup(menu);
    }
};

TEST_F(IrisGlMenus, FunctionsOfEntriesComeBeforeThatOfTheMenu) {
    const long menu =
        defpup(const_cast<char*>("T %t %F|a|b %f|c %n|d %x9"), plus_hundred, doubled, doubled);
    EXPECT_EQ(chosen(menu, 1), 101);
    EXPECT_EQ(chosen(menu, 2), 104);
    EXPECT_EQ(chosen(menu, 3), 6);  // %n: without the menu's function
    EXPECT_EQ(chosen(menu, 4), 109);
}

TEST_F(IrisGlMenus, ASubmenuOpensBesideItsEntry) {
    const long inner = defpup(const_cast<char*>("x %x50|y %x60"));
    const long menu = defpup(const_cast<char*>("a|more %m"), inner);
    enter(DOWNARROWKEY, 1);
    enter(DOWNARROWKEY, 1);
    enter(RETKEY, 1);
    enter(DOWNARROWKEY, 1);
    enter(DOWNARROWKEY, 1);
    enter(RETKEY, 1);
    EXPECT_EQ(dopup(menu), 60);
}

// A program that is slow reads the press when the button is up again, elsewhere.
TEST_F(IrisGlMenus, APressDragAndReleaseChooseHoweverLateTheMenuOpens) {
    const long menu = defpup(const_cast<char*>("T %t|a|b|c"));
    const Window& w = current_window();
    const auto move = [&](long x, long y) {
        happen(MOUSEX, w.x + x);
        happen(MOUSEY, w.y + y);
    };
    qdevice(RIGHTMOUSE);
    tie(RIGHTMOUSE, MOUSEX, MOUSEY);
    for (const long row : {1, 2, 3, 4}) {
        move(5, 80);
        happen(RIGHTMOUSE, 1);
        move(15, 80 - 18 * row - 9);  // rows of 18 pixels, the first is the title
        happen(RIGHTMOUSE, 0);
        for (const long device : {RIGHTMOUSE, MOUSEX, MOUSEY}) EXPECT_EQ(qread(nullptr), device);
        EXPECT_EQ(dopup(menu), row <= 3 ? row : -1) << "row " << row;
        EXPECT_EQ(qtest(), 0);
    }
    tie(RIGHTMOUSE, 0, 0);
    unqdevice(RIGHTMOUSE);
}

TEST_F(IrisGlMenus, AGreyEntryCannotBeTaken) {
    const long menu = defpup(const_cast<char*>("a|b"));
    setpup(menu, 1, PUP_GREY);
    EXPECT_EQ(chosen(menu, 1), -1);
    EXPECT_EQ(chosen(menu, 2), 2);
    setpup(menu, 1, PUP_CHECK);
    EXPECT_EQ(chosen(menu, 1), 1);
    setpup(menu, 7, PUP_GREY);
}

TEST_F(IrisGlDevices, CursorsHaveTheSizeOfTheirType) {
    short n = 7;
    unsigned short c = 1, mask = 1;
    long on = 0;
    getcursor(&n, &c, &mask, &on);
    EXPECT_EQ(n, 0);
    EXPECT_TRUE(on);
    unsigned short image[128] = {0x8000, 0x0001};
    image[64] = 0x8000;
    curstype(C32X2);
    defcursor(1, image);
    const CursorImage& made = program().cursors.at(1);
    EXPECT_EQ(made.size, 32);
    EXPECT_EQ(made.pixels[0], 3);   // both planes
    EXPECT_EQ(made.pixels[31], 1);  // the second word of the lowest row
    curorigin(1, 40, 0);
    EXPECT_EQ(made.x, 0);
    curorigin(1, 4, 5);
    EXPECT_EQ(made.y, 5);
    setcursor(1, 0, 0);
    setcursor(9, 0, 0);  // not defined
    cursoff();
    getcursor(&n, &c, &mask, &on);
    EXPECT_EQ(n, 1);
    EXPECT_FALSE(on);
    curson();
    curstype(CCROSS);
    defcursor(2, image);
    EXPECT_EQ(program().cursors.at(2).x, 15);
    defcursor(0, image);
    EXPECT_FALSE(program().cursors.contains(0));
    setcursor(0, 0, 0);
    curstype(C16X1);
    program().cursors.clear();
}

TEST_F(IrisGlDevices, CursorsHaveAMapOfTheirOwn) {
    mapcolor(1, 1, 2, 3);
    drawmode(CURSORDRAW);
    mapcolor(1, 9, 8, 7);
    short r = 0, g = 0, b = 0;
    getmcolor(1, &r, &g, &b);
    EXPECT_EQ(r, 9);
    drawmode(NORMALDRAW);
    getmcolor(1, &r, &g, &b);
    EXPECT_EQ(r, 1);
    mapcolor(1, 255, 0, 0);
}

TEST_F(IrisGlDevices, WindowsTakeTheirHintsOnce) {
    long x = 0, y = 0, w = 0, h = 0;
    prefposition(100, 139, 200, 229);
    const long placed = winopen("placed");
    getorigin(&x, &y);
    getsize(&w, &h);
    EXPECT_EQ(x, 100);
    EXPECT_EQ(y, 200);
    EXPECT_EQ(w, 40);
    EXPECT_EQ(h, 30);
    winmove(7, 8);
    getorigin(&x, &y);
    EXPECT_EQ(x, 7);
    winposition(1, 20, 2, 11);
    getsize(&w, &h);
    EXPECT_EQ(w, 20);
    EXPECT_EQ(h, 10);
    minsize(50, 60);
    maxsize(70, 80);
    prefsize(10, 500);
    const long limited = winopen("limited");
    getsize(&w, &h);
    EXPECT_EQ(w, 50);
    EXPECT_EQ(h, 80);
    keepaspect(2, 1);
    maxsize(64, 64);
    const long wide = winopen("wide");
    getsize(&w, &h);
    EXPECT_EQ(w, 2 * h);
    for (const long window : {placed, limited, wide}) winclose(window);
    EXPECT_EQ(winget(), id);
}

TEST_F(IrisGlDevices, ObjectsThatCallOneAnotherEnd) {
    for (const long name : {1L, 2L}) {
        makeobj(name);
        for (int i = 0; i < 8; ++i) callobj(3 - name);
        color(Colorindex(name));
        closeobj();
    }
    callobj(1);
    EXPECT_EQ(getcolor(), 1);
    delobj(1);
    delobj(2);
}

}  // namespace gw::irisgl
