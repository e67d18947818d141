"""Draws by PyOpenGL on gw's libOSMesa, and prints its name and the middle pixel: a program, no test."""
import ctypes

import gw.osmesa

from OpenGL import GL, osmesa

context = osmesa.OSMesaCreateContext(GL.GL_RGBA, None)
pixels = (ctypes.c_ubyte * (8 * 8 * 4))()
assert osmesa.OSMesaMakeCurrent(context, pixels, GL.GL_UNSIGNED_BYTE, 8, 8)
GL.glClearColor(1, 0, 0, 1)
GL.glClear(GL.GL_COLOR_BUFFER_BIT)
GL.glColor3f(0, 1, 0)
GL.glBegin(GL.GL_TRIANGLES)
for x, y in ((-1, -1), (1, -1), (0, 1)):
    GL.glVertex2f(x, y)
GL.glEnd()
GL.glFinish()
print(gw.osmesa.library)
print(GL.glGetString(GL.GL_VENDOR).decode(), list(pixels[4 * (4 * 8 + 4):][:4]), list(pixels[-4:]))
