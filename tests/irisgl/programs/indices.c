/* Colour map mode: a square of index 37, by call 7 of the frame. */
#include <gl/gl.h>

int main(void) {
    prefsize(8, 8);
    winopen("indices");
    doublebuffer();             /* call 0 of the window */
    gconfig();                  /* 1 */
    mapcolor(0, 5, 6, 7);       /* 2 */
    mapcolor(37, 200, 100, 50); /* 3 */
    color(0);                   /* 4 */
    clear();                    /* 5 */
    color(37);                  /* 6 */
    rectfi(2, 2, 5, 5);         /* 7 */
    swapbuffers();
    return 0;
}
