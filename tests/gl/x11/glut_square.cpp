// A program of freeglut, linked with the system's libGL: a yellow square on blue.
#include <GL/glut.h>

namespace {

void display() {
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor3f(1, 1, 0);
    glRectf(-1, -1, 0, 0);
    glutSwapBuffers();
}

}  // namespace

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(200, 100);
    glutInitWindowPosition(0, 0);
    glutCreateWindow("square");
    glutDisplayFunc(display);
    glutMainLoop();
}
