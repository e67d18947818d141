/* The font manager: one font, "screen", in whole multiples of its size. */
#ifndef GW_IRISGL_FMCLIENT_H
#define GW_IRISGL_FMCLIENT_H
#ifdef __cplusplus
extern "C" {
#endif
typedef long fmfonthandle;
typedef struct {
    long printermatched, fixed_width, xorig, yorig, xsize, ysize, height, width;
    long nglyphs, matrix00, matrix01, matrix10, matrix11;
} fmfontinfo;
#include <gl/fmfunctions.h>
#ifdef __cplusplus
}
#endif
#endif
