/* The font manager: <gl/gl.h> has its types and functions. */
#ifndef GW_IRISGL_FMCLIENT_H
#define GW_IRISGL_FMCLIENT_H
#include <gl/gl.h>
#endif
