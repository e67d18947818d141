/* Declarations as in 1990. */
/* clang-format off */
/* Functions without prototypes, int for long, objects in int, an event that GW_INPUT makes. */
#include <gl.h>
#include <device.h>

int corner[] = {2, 2};
long far_corner[2] = {5, 5};
int objects[] = {0, 77};

square(a, b)
int *a;
long *b;
{
    rectfi(a[0], a[1], (int) b[0], (int) b[1]);
}

main(argc, argv)
int argc;
char **argv;
{
    short value;
    int width, height, c[3];
    Object *object = objects;

    prefsize(8, 8);
    winopen("squares");
    doublebuffer();
    RGBmode();
    gconfig();
    getsize(&width, &height);
    if (width != 8 || height != 8) return 1;
    if (!winget()) exit();
    qdevice(LEFTMOUSE);
    if (qread(&value) != REDRAW || qread(&value) != INPUTCHANGE) return 2;
    if (qread(&value) != LEFTMOUSE) return 3;
    makeobj(*object = genobj());
    closeobj();
    if (!isobj(objects[0]) || objects[1] != 77) return 4;
    cpack(0x0);
    clear();
    c[0] = 10;
    c[1] = 20;
    c[2] = 30;
    c3i(c);
    square(corner, far_corner);
    swapbuffers();
    return 0;
}
