/*
 * hidden: hidden surfaces, as a class of 1991 would try them.
 *
 * Two blocks and a ring of blocks, in colour map mode. The menu of the right
 * button chooses who removes what is hidden:
 *
 *   Z-buffer           the machine compares depths
 *   Painter            the program draws the farthest polygon first
 *   Back faces         the machine drops polygons that face away
 *   As they come       nobody
 *
 * Keys 1 to 4 choose the same. Left button: turn. Space: turn by itself.
 * Escape: the end.
 */
/* clang-format off */
#include <gl.h>
#include <device.h>
#include <math.h>
#include <stdlib.h>

#define ZBUFFER  1
#define PAINTER  2
#define BACKFACE 3
#define NOTHING  4
#define SPIN     5
#define LEAVE    6

#define RAMPS 3                 /* colours of things */
#define SHADES 32               /* brightnesses of each */
#define FIRST 64                /* map entry of the first */

#define BLOCKS 10
#define FACES (6 * BLOCKS)

typedef struct {
    float corner[4][3];         /* counterclockwise from outside */
    float normal[3];
    int ramp;
    float distance;             /* of its centre to the eye, this frame */
} Face;

static Face faces[FACES];
static Face *order[FACES];
static int count = 0;

static int method = ZBUFFER;
static int spins = 1;
static float pitch = 25.0, yaw = 30.0;

static char *names[] = { "", "Z-buffer", "Painter", "Back faces", "As they come" };

/* A block with its centre, half its size, turned about z. */
block(cx, cy, cz, sx, sy, sz, turn, ramp)
double cx, cy, cz, sx, sy, sz, turn;
int ramp;
{
    static int corners[6][4] = {
        {0, 4, 6, 2}, {1, 3, 7, 5},     /* -x, +x */
        {0, 1, 5, 4}, {2, 6, 7, 3},     /* -y, +y */
        {0, 2, 3, 1}, {4, 5, 7, 6}      /* -z, +z */
    };
    static float outward[6][3] = {
        {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}
    };
    double c = cos(turn), s = sin(turn);
    int f, v;

    for (f = 0; f < 6; f++) {
        Face *face = &faces[count];
        for (v = 0; v < 4; v++) {
            int which = corners[f][v];
            double x = which & 1 ? sx : -sx;
            double y = which & 2 ? sy : -sy;
            double z = which & 4 ? sz : -sz;
            face->corner[v][0] = cx + c * x - s * y;
            face->corner[v][1] = cy + s * x + c * y;
            face->corner[v][2] = cz + z;
        }
        face->normal[0] = c * outward[f][0] - s * outward[f][1];
        face->normal[1] = s * outward[f][0] + c * outward[f][1];
        face->normal[2] = outward[f][2];
        face->ramp = ramp;
        order[count] = face;
        count++;
    }
}

things()
{
    int i;

    block(0.0, 0.0, 0.0, 0.9, 0.35, 0.35, 0.4, 0);
    block(0.1, 0.1, 0.0, 0.3, 0.3, 0.95, 0.9, 1);       /* pierces the first */
    for (i = 0; i < 8; i++) {
        double a = i * M_PI / 4;
        block(1.7 * cos(a), 1.7 * sin(a), 0.0, 0.22, 0.45, 0.22, a, 2);
    }
}

/* Each thing has a ramp from dark to its colour. */
ramps()
{
    static short bright[RAMPS][3] = { {255, 176, 80}, {96, 200, 255}, {150, 230, 120} };
    int r, i;

    for (r = 0; r < RAMPS; r++)
        for (i = 0; i < SHADES; i++) {
            double part = 0.15 + 0.85 * i / (SHADES - 1);
            mapcolor(FIRST + r * SHADES + i, (int)(part * bright[r][0]),
                (int)(part * bright[r][1]), (int)(part * bright[r][2]));
        }
    mapcolor(32, 24, 28, 40);
}

/* qsort: the farthest first */
farther(a, b)
Face **a, **b;
{
    if ((*a)->distance > (*b)->distance) return -1;
    return (*a)->distance < (*b)->distance;
}

frame()
{
    Matrix m;
    float ey[3], length;
    int i, v;

    color(32);
    clear();
    if (method == ZBUFFER) zclear();

    pushmatrix();
    translate(0.0, 0.0, -6.0);
    rot(pitch - 90.0, 'x');
    rot(yaw, 'z');
    getmatrix(m);
    /* The eye in the things' own coordinates: m times it is 0. */
    for (i = 0; i < 3; i++)
        ey[i] = -(m[3][0] * m[i][0] + m[3][1] * m[i][1] + m[3][2] * m[i][2]);
    length = sqrt(ey[0] * ey[0] + ey[1] * ey[1] + ey[2] * ey[2]);

    for (i = 0; i < count; i++) {
        float d[3];
        for (v = 0; v < 3; v++)
            d[v] = (faces[i].corner[0][v] + faces[i].corner[2][v]) / 2 - ey[v];
        faces[i].distance = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        order[i] = &faces[i];
    }
    if (method == PAINTER) qsort(order, count, sizeof(Face *), farther);

    zbuffer(method == ZBUFFER);
    backface(method == BACKFACE);
    for (i = 0; i < count; i++) {
        Face *f = order[i];
        float light = (f->normal[0] * ey[0] + f->normal[1] * ey[1] +
            f->normal[2] * ey[2]) / length;
        if (light < 0) light = -light;
        color(FIRST + f->ramp * SHADES + (int)(light * (SHADES - 1)));
        bgnpolygon();
        for (v = 0; v < 4; v++) v3f(f->corner[v]);
        endpolygon();
    }
    zbuffer(FALSE);
    backface(FALSE);
    popmatrix();

    pushmatrix();
    color(WHITE);
    cmov(-2.6, -2.3, -6.0);
    charstr(names[method]);
    popmatrix();
    swapbuffers();
}

int choose(what)
int what;
{
    if (what >= ZBUFFER && what <= NOTHING) method = what;
    if (what == SPIN) spins = !spins;
    return what == LEAVE;
}

main()
{
    int menu, turns = 0;
    short value;
    long device, x = 0, y = 0, nx, ny;

    keepaspect(1, 1);
    prefsize(480, 480);
    winopen("hidden surfaces");
    doublebuffer();
    cmode();
    gconfig();
    ramps();
    things();
    mmode(MVIEWING);
    perspective(500, 1.0, 2.0, 12.0);
    lsetdepth(getgdesc(GD_ZMIN), getgdesc(GD_ZMAX));
    shademodel(FLAT);

    menu = defpup("Hidden surfaces %t|Z-buffer %x1|Painter %x2|Back faces %x3|As they come %x4%l|Turn by itself %x5|Quit %x6");
    qdevice(ESCKEY);
    qdevice(LEFTMOUSE);
    qdevice(RIGHTMOUSE);
    qdevice(KEYBD);

    for (;;) {
        while (qtest()) {
            device = qread(&value);
            switch (device) {
            case REDRAW:
                reshapeviewport();
                break;
            case ESCKEY:
                if (value == 0) exit(0);
                break;
            case KEYBD:
                if (value >= '1' && value <= '4') choose(value - '0');
                if (value == ' ') choose(SPIN);
                break;
            case LEFTMOUSE:
                turns = value;
                x = getvaluator(MOUSEX);
                y = getvaluator(MOUSEY);
                break;
            case RIGHTMOUSE:
                if (value && choose((int) dopup(menu))) exit(0);
                break;
            }
        }
        if (turns) {
            nx = getvaluator(MOUSEX);
            ny = getvaluator(MOUSEY);
            yaw += (nx - x) * 0.5;
            pitch -= (ny - y) * 0.5;
            x = nx;
            y = ny;
        } else if (spins)
            yaw += 0.5;
        frame();
    }
}
