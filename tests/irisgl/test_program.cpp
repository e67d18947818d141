// Objects, picking, events, menus.
#include "tests/irisgl/support.h"

#include <fstream>

namespace gw::irisgl {

using IrisGlProgram = IrisGl;

TEST_F(IrisGlProgram, ObjectsAreEditedBetweenTheirTags) {
    makeobj(1);
    color(1);
    maketag(10);
    color(2);
    maketag(11);
    color(3);
    closeobj();
    callobj(1);
    EXPECT_EQ(getcolor(), 3);
    editobj(1);
    objdelete(11, -3);
    closeobj();
    callobj(1);
    EXPECT_EQ(getcolor(), 2);
    editobj(1);
    objreplace(10);
    color(9);
    closeobj();
    callobj(1);
    EXPECT_EQ(getcolor(), 9);
    delobj(1);
    EXPECT_FALSE(isobj(1));
    callobj(1);
    closeobj();
}

TEST_F(IrisGlProgram, ArraysOfAnObjectAreReadWhenItIsMade) {
    float p[4][2] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
    color(0);
    clear();
    makeobj(1);
    color(4);
    polf2(4, p);
    closeobj();
    EXPECT_EQ(index_at(4, 4), 0);
    for (auto& v : p) v[0] = v[1] = 0;
    callobj(1);
    EXPECT_EQ(index_at(4, 4), 4);
    delobj(1);
}

TEST_F(IrisGlProgram, AnObjectThatCallsItselfEnds) {
    makeobj(2);
    callobj(2);
    closeobj();
    callobj(2);
    delobj(2);
}

TEST_F(IrisGlProgram, PickNamesWhatIsNearTheCursor) {
    setvaluator(MOUSEX, short(current_window().x + 4), 0, XMAXSCREEN);
    setvaluator(MOUSEY, short(current_window().y + 4), 0, YMAXSCREEN);
    short buffer[20] = {};
    picksize(2, 2);
    pick(buffer, 20);
    ortho2(-0.5f, 15.5f, -0.5f, 15.5f);
    initnames();
    loadname(7);
    rectfi(3, 3, 5, 5);
    loadname(8);
    rectfi(10, 10, 12, 12);
    EXPECT_EQ(endpick(buffer), 1);
    EXPECT_EQ(buffer[0], 1);
    EXPECT_EQ(buffer[1], 7);
    EXPECT_EQ(endpick(buffer), 0);
}

TEST_F(IrisGlProgram, TiedValuatorsFollowTheirButton) {
    short value = 0;
    qdevice(LEFTMOUSE);
    tie(LEFTMOUSE, MOUSEX, MOUSEY);
    setvaluator(MOUSEX, 30, 0, 1279);
    setvaluator(MOUSEY, 40, 0, 1023);
    happen(LEFTMOUSE, 1);
    EXPECT_EQ(qtest(), LEFTMOUSE);
    EXPECT_EQ(qread(&value), LEFTMOUSE);
    EXPECT_EQ(value, 1);
    EXPECT_EQ(qread(&value), MOUSEX);
    EXPECT_EQ(value, 30);
    EXPECT_EQ(qread(&value), MOUSEY);
    EXPECT_EQ(value, 40);
    EXPECT_EQ(qtest(), 0);
    EXPECT_TRUE(getbutton(LEFTMOUSE));
}

TEST_F(IrisGlProgram, AMenuAnswersWithTheValueOfItsEntry) {
    const long menu = defpup(const_cast<char*>("Title %t|one|two %x20|three"));
    happen(RIGHTMOUSE, 1);
    enter(DOWNARROWKEY, 1);
    enter(DOWNARROWKEY, 1);
    enter(RETKEY, 1);
    EXPECT_EQ(dopup(menu), 20);
    enter(ESCKEY, 1);
    EXPECT_EQ(dopup(menu), -1);
    EXPECT_EQ(dopup(menu), -1);  // nothing can come
    freepup(menu);
    EXPECT_EQ(dopup(menu), -1);
}

TEST_F(IrisGlProgram, OtherEventsWaitWhileAMenuIsOpen) {
    short value = 0;
    const long menu = newpup();
    addtopup(menu, const_cast<char*>("only"));
    qenter(REDRAW, 5);
    enter(DOWNARROWKEY, 1);
    enter(RETKEY, 1);
    EXPECT_EQ(dopup(menu), 1);
    EXPECT_EQ(qread(&value), REDRAW);
    EXPECT_EQ(value, 5);
    freepup(menu);
}

TEST_F(IrisGlProgram, WhatIsLeftOutReturnsZero) {
    EXPECT_EQ(ilbuffer(1), 0);
    EXPECT_EQ(getvideo(3), 0);
}

TEST_F(IrisGlProgram, AWaitThatNothingCanEndEndsTheProgram) {
    short value = 0;
    EXPECT_EXIT(qread(&value), testing::ExitedWithCode(0), "no more events come");
}

// None of these loops swaps buffers or gets an event.
TEST_F(IrisGlProgram, LoopsWithoutSwapsEndWithTheLastFrame) {
    const auto runs = [](const auto& body, const char* frames = "0-3") {
        setenv("GW_FRAMES", frames, 1);
        for (;;) body();
    };
    const std::string why = "the last frame of GW_FRAMES is over";
    EXPECT_EXIT(runs([] { qtest(); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { getvaluator(MOUSEX); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { getbutton(LEFTMOUSE); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { gflush(); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { finish(); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { sginap(1); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { gsync(); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { clear(); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { czclear(0, 0); }), testing::ExitedWithCode(0), why);
    EXPECT_EXIT(runs([] { pnt2i(3, 3); }, "0"), testing::ExitedWithCode(0), why);
}

// 10,000 make a frame; 100,000 in double buffer mode, where a swap may follow.
TEST_F(IrisGlProgram, PointsLinesAndPolygonsArePartsOfAFrame) {
    const auto parts = [](const auto& draw) {
        const unsigned before = program().events.parts;
        draw();
        return program().events.parts - before;
    };
    EXPECT_EQ(parts([] { pnt2i(3, 3); }), 10u);
    EXPECT_EQ(parts([] { rectfi(3, 3, 4, 4); }), 10u);
    doublebuffer();
    EXPECT_EQ(parts([] { draw2i(3, 3); }), 1u);
    EXPECT_EQ(parts([] { circfi(3, 3, 2); }), 1u);
}

TEST_F(IrisGlProgram, AnOpenedWindowIsToBeRedrawnAndHasTheInput) {
    short value = 0;
    prefsize(8, 8);
    const long other = winopen("other");
    EXPECT_EQ(qread(&value), REDRAW);
    EXPECT_EQ(value, other);
    EXPECT_EQ(qread(&value), INPUTCHANGE);
    EXPECT_EQ(value, other);
    EXPECT_EQ(qtest(), 0);
    winclose(other);
}

TEST_F(IrisGlProgram, TheMouseBeginsInTheMiddleOfTheScreen) {
    EXPECT_EQ(getvaluator(MOUSEX), XMAXSCREEN / 2);
    EXPECT_EQ(getvaluator(MOUSEY), YMAXSCREEN / 2);
}

TEST_F(IrisGlProgram, GetgdescAnswersWithMinusOneWhereItKnowsNothing) {
    EXPECT_EQ(getgdesc(GD_XPMAX), 1280);
    EXPECT_EQ(getgdesc(GD_ZMIN), -0x800000);
    EXPECT_EQ(getgdesc(GD_ZMAX), 0x7fffff);
    EXPECT_EQ(getgdesc(GD_NMMAPS), 16);
    EXPECT_EQ(getgdesc(12345), -1);
}

TEST_F(IrisGlProgram, ASecondWindowHasItsOwnState) {
    color(6);
    prefsize(8, 8);
    const long other = winopen("other");
    color(2);
    EXPECT_EQ(winget(), other);
    winset(id);
    EXPECT_EQ(getcolor(), 6);
    winclose(other);
    winset(99);
    EXPECT_EQ(winget(), id);
}

TEST(IrisGlWithoutWindow, CallsAreIgnored) {
    color(3);
    clear();
    popmatrix();
    float m[4][4];
    getmatrix(m);
    EXPECT_EQ(getcolor(), 0);
    EXPECT_EQ(winget(), -1);
}

}  // namespace gw::irisgl
