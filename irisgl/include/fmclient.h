/* The font manager: its types. Its functions are not offered. */
#ifndef GW_IRISGL_FMCLIENT_H
#define GW_IRISGL_FMCLIENT_H
typedef long fmfonthandle;
typedef struct {
    long printermatched, fixed_width, xorig, yorig, xsize, ysize, height, width;
    long nglyphs, matrix00, matrix01, matrix10, matrix11;
} fmfontinfo;
#endif
