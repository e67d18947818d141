/* The header of SGI image files. The functions of libimage are not offered. */
#ifndef GW_IRISGL_IMAGE_H
#define GW_IRISGL_IMAGE_H
#define IMAGIC 0732
#define TYPEMASK 0xff00
#define BPPMASK 0x00ff
#define ITYPE_VERBATIM 0x0000
#define ITYPE_RLE 0x0100
#define CM_NORMAL 0
#define CM_DITHERED 1
#define CM_SCREEN 2
#define CM_COLORMAP 3
#endif
