/* A triangle over the middle of 32 x 32 pixels, written as a picture. */
#include <GL/osmesa.h>
#include <stdio.h>

static unsigned char pixels[32 * 32 * 4];

int main(void) {
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, 0);
    if (!OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 32, 32)) return 1;
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3ub(255, 128, 0);
    glBegin(GL_TRIANGLES);
    glVertex2f(-0.9f, -0.9f);
    glVertex2f(0.9f, -0.9f);
    glVertex2f(0, 0.9f);
    glEnd();
    glFinish();
    FILE* file = fopen("triangle.ppm", "wb");
    fprintf(file, "P6\n32 32\n255\n");
    for (int i = 0; i < 32 * 32; i++) fwrite(pixels + 4 * i, 3, 1, file);
    fclose(file);
    OSMesaDestroyContext(context);
    return 0;
}
