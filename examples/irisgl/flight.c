/*
 * flight: over hills, with depth cueing.
 *
 * The hills are drawn row by row, the farthest first; each patch covers what
 * lies behind it, so no Z-buffer is needed. Depth cueing makes far lines dark:
 * the machine takes the index of a line's pixel from its depth. The instruments
 * are in the overlay planes: the hills are drawn below them and need not know.
 *
 * Mouse left and right: turn. Up and down: climb and sink. Arrow keys do the
 * same. Menu of the right button: speed, depth cueing, hills or lines only.
 * Escape: the end.
 */
/* clang-format off */
#include <gl.h>
#include <device.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define SIDE 44                 /* patches that are seen, each way */
#define FIRST 64                /* the ramp of the lines */
#define LAST 127
#define SKY 32
#define GROUND 33
#define DIAL 1                  /* of the overlay planes */

#define SLOW   1
#define FAST   2
#define CUEING 3
#define HIDING 4
#define LEAVE  5

static double ex = 0.0, ey = 0.0, ez = 4.0, heading = 0.0;
static double speed = 0.15;
static int cueing = 1, hiding = 1;
static int left = 0, right = 0, up = 0, down = 0;

static double height(x, y)
double x, y;
{
    double h = sin(x * 0.35) * cos(y * 0.3) * 1.4 + sin(x * 0.13 + y * 0.17) * 1.6;
    return h < -1.2 ? -1.2 : h;         /* lakes */
}

colors()
{
    int i;

    for (i = FIRST; i <= LAST; i++) {
        double part = (double)(i - FIRST) / (LAST - FIRST);
        mapcolor(i, (int)(20 + 140 * part), (int)(40 + 215 * part), (int)(60 + 60 * part));
    }
    mapcolor(SKY, 12, 16, 40);
    mapcolor(GROUND, 8, 20, 24);
    drawmode(OVERDRAW);
    mapcolor(DIAL, 255, 40, 40);
    drawmode(NORMALDRAW);
}

view()
{
    perspective(600, 1.6, 0.3, 60.0);
}

/* A patch and its edges, since it covers those of its neighbours. */
piece(a, b, c, d)
float *a, *b, *c, *d;
{
    if (hiding) {
        depthcue(FALSE);
        color(GROUND);
        bgnpolygon();
        v3f(a);
        v3f(b);
        v3f(c);
        v3f(d);
        endpolygon();
    }
    if (cueing) depthcue(TRUE);
    else {
        depthcue(FALSE);
        color(LAST);
    }
    bgnclosedline();
    v3f(a);
    v3f(b);
    v3f(c);
    v3f(d);
    endclosedline();
}

/* lookat has y up; the hills' second axis points to -z. */
corner(v, i, j)
float *v;
int i, j;
{
    v[0] = i;
    v[1] = height((double) i, (double) j);
    v[2] = -j;
}

/* Patches from far to near of the eye, in both directions of each axis. */
hills()
{
    int near_i = (int) floor(ex), near_j = (int) floor(ey);
    double c = cos(heading), s = sin(heading);
    int step, side, k, i, j;

    /* Rows run across the axis that the eye looks along more. */
    for (step = SIDE; step >= 0; step--)
        for (side = SIDE / 2 + step / 2; side >= 0; side--)
            for (k = -1; k <= 1; k += 2) {
                float a[3], b[3], cc[3], d[3];
                if (side == 0 && k == 1) continue;
                if (fabs(s) > fabs(c)) {
                    j = near_j + (s > 0 ? step : -step);
                    i = near_i + k * side;
                } else {
                    i = near_i + (c > 0 ? step : -step);
                    j = near_j + k * side;
                }
                corner(a, i, j);
                corner(b, i + 1, j);
                corner(cc, i + 1, j + 1);
                corner(d, i, j + 1);
                piece(a, b, cc, d);
            }
}

/* A scale of degrees that moves with the heading, and the height. */
instruments()
{
    double degrees = 90.0 - heading * 180.0 / M_PI;
    int first = (int) floor(degrees / 10.0) - 6, i, x;
    char text[32];

    depthcue(FALSE);
    drawmode(OVERDRAW);
    ortho2(-0.5, 639.5, -0.5, 399.5);
    color(0);
    clear();
    color(DIAL);
    for (i = first; i < first + 14; i++) {
        x = 320 + (int) ((i * 10 - degrees) * 3.0);
        move2i(x, 372);
        draw2i(x, i % 3 == 0 ? 384 : 378);
    }
    move2i(320, 368);
    draw2i(320, 360);
    sprintf(text, "%03d", ((int) floor(degrees + 0.5) % 360 + 360) % 360);
    cmov2i(308, 344);
    charstr(text);
    sprintf(text, "height %4.1f", ez);
    cmov2i(16, 16);
    charstr(text);
    drawmode(NORMALDRAW);
    view();
}

frame()
{
    color(SKY);
    clear();
    pushmatrix();
    lookat(ex, ez, -ey, ex + cos(heading), ez - 0.25, -ey - sin(heading), 0);
    hills();
    popmatrix();
    instruments();
    swapbuffers();
}

fly()
{
    double floor_here, turn, climb;

    turn = (getvaluator(MOUSEX) - 640.0) / 640.0;
    climb = (getvaluator(MOUSEY) - 512.0) / 512.0;
    if (fabs(turn) < 0.1 || left || right) turn = right - left;
    if (fabs(climb) < 0.1 || up || down) climb = up - down;
    heading -= 0.02 * turn;
    ex += speed * cos(heading);
    ey += speed * sin(heading);
    ez += 0.06 * climb;
    floor_here = height(ex, ey) + 1.0;
    if (ez < floor_here) ez = floor_here;
    if (ez > 9.0) ez = 9.0;
}

int choose(what)
int what;
{
    switch (what) {
    case SLOW: speed = 0.05; break;
    case FAST: speed = 0.3; break;
    case CUEING: cueing = !cueing; break;
    case HIDING: hiding = !hiding; break;
    }
    return what == LEAVE;
}

main()
{
    int menu;
    short value;

    prefsize(640, 400);
    winopen("flight");
    doublebuffer();
    cmode();
    overlay(2);
    gconfig();
    colors();
    mmode(MVIEWING);
    view();
    lsetdepth(0x0, 0x7fffff);
    /* Near lines are bright. Depths of a perspective crowd at the far end. */
    lshaderange(FIRST, LAST, 0x780000, 0x7fffff);
    setvaluator(MOUSEX, 640, 0, 1279);
    setvaluator(MOUSEY, 512, 0, 1023);

    menu = defpup("Flight %t|Slow %x1|Fast %x2%l|Depth cueing %x3|Hidden lines %x4%l|Quit %x5");
    qdevice(ESCKEY);
    qdevice(RIGHTMOUSE);
    qdevice(LEFTARROWKEY);
    qdevice(RIGHTARROWKEY);
    qdevice(UPARROWKEY);
    qdevice(DOWNARROWKEY);

    for (;;) {
        while (qtest())
            switch (qread(&value)) {
            case REDRAW: reshapeviewport(); break;
            case ESCKEY: if (value == 0) exit(0); break;
            case LEFTARROWKEY: left = value; break;
            case RIGHTARROWKEY: right = value; break;
            case UPARROWKEY: up = value; break;
            case DOWNARROWKEY: down = value; break;
            case RIGHTMOUSE: if (value && choose((int) dopup(menu))) exit(0); break;
            }
        fly();
        frame();
    }
}
