/* Drawing into windows of X that a program opens itself. The functions are not offered: they say so,
   and answer with an error. */
#ifndef GW_IRISGL_GLWS_H
#define GW_IRISGL_GLWS_H

typedef struct {
    int buffer, mode, arg;
} GLXconfig;

/* buffer */
#define GLX_NORMAL 1
#define GLX_OVERLAY 2
#define GLX_UNDERLAY 3
#define GLX_POPUP 4

/* mode */
#define GLX_RGB 1
#define GLX_DOUBLE 2
#define GLX_BUFSIZE 3
#define GLX_STENSIZE 4
#define GLX_ACSIZE 5
#define GLX_VISUAL 6
#define GLX_COLORMAP 7
#define GLX_WINDOW 8
#define GLX_ZSIZE 9
#define GLX_MSSAMPLE 10
#define GLX_MSZSIZE 11
#define GLX_MSSSIZE 12
#define GLX_RGBSIZE 13
#define GLX_STEREOBUF 14
#define GLX_NOCONFIG 0

/* results */
#define GLWS_NOERROR 0
#define GLWS_NOWINDOW (-1)
#define GLWS_NOCONTEXT (-2)
#define GLWS_NOVISUAL (-3)
#define GLWS_NOCOLORMAP (-4)
#define GLWS_NOWINDOWCONFIG (-5)

#endif
