/* IRIS GL of the GL4 manuals: types, constants and functions. Programs of 1990 include it as
   <gl.h> or <gl/gl.h> and are compiled with `gw irisgl-config --cflags`. docs/irisgl.md */
#ifndef GW_IRISGL_GL_H
#define GW_IRISGL_GL_H

#ifndef TRUE
#define TRUE 1
#define FALSE 0
#endif
#ifndef NULL
#define NULL 0
#endif

#define XMAXSCREEN 1279
#define YMAXSCREEN 1023
#define XMAXMEDIUM 1023
#define YMAXMEDIUM 767
#define XMAX170 645
#define YMAX170 484
#define XMAXPAL 779
#define YMAXPAL 574

typedef unsigned char Byte;
typedef long Boolean;
typedef char* String;
typedef short Angle;
typedef short Screencoord;
typedef short Scoord;
typedef long Icoord;
typedef float Coord;
typedef float Matrix[4][4];
typedef unsigned short Colorindex;
typedef unsigned char RGBvalue;
typedef unsigned short Device;
typedef unsigned short Linestyle;
#ifndef X_H /* X has a Cursor too; it is included first */
typedef unsigned short Cursor[16];
#endif
typedef unsigned short Pattern16[16];
typedef unsigned short Pattern32[64];
typedef unsigned short Pattern64[256];
typedef int Object; /* as wide as the int in which programs of 32 bits keep it */
typedef int Tag;
typedef int Offset;
typedef struct {
    unsigned short offset;
    Byte w, h;
    signed char xoff, yoff;
    short width;
} Fontchar;
typedef struct {
    unsigned int value, offset;
    short w, h, xoff, yoff, xmove, ymove;
} Lfontchar;

/* limits and the tags that every object has */
#define ATTRIBSTACKDEPTH 10
#define VPSTACKDEPTH 8
#define MATRIXSTACKDEPTH 32
#define NAMESTACKDEPTH 1025
#define STARTTAG (-2)
#define ENDTAG (-3)

/* colours of the default map */
#define BLACK 0
#define RED 1
#define GREEN 2
#define YELLOW 3
#define BLUE 4
#define MAGENTA 5
#define CYAN 6
#define WHITE 7

/* drawmode */
#define NORMALDRAW 0x010
#define PUPDRAW 0x020
#define OVERDRAW 0x040
#define UNDERDRAW 0x080
#define CURSORDRAW 0x100
#define PUP_NONE 0
#define PUP_GREY 1
#define PUP_BOX 2
#define PUP_CHECK 4
#define PUP_CURSOR 1
#define PUP_CLEAR 0
#define PUP_COLOR 1
#define PUP_BLACK 2
#define PUP_WHITE 3

/* getbuffer, getdisplaymode, getcmmode */
#define NOBUFFER 0
#define BCKBUFFER 1
#define FRNTBUFFER 2
#define BOTHBUFFERS 3
#define DRAWZBUFFER 4
#define DMRGB 0
#define DMSINGLE 1
#define DMDOUBLE 2
#define DMRGBDOUBLE 5
#define CMAPMULTI 0
#define CMAPONE 1

/* shademodel, mmode, polymode, frontface */
#define FLAT 0
#define GOURAUD 1
#define MSINGLE 0
#define MPROJECTION 1
#define MVIEWING 2
#define MTEXTURE 3
#define PYM_FILL 1
#define PYM_POINT 2
#define PYM_LINE 3
#define PYM_HOLLOW 4
#define PYM_LINE_FAST 5

/* depth */
#define ZF_NEVER 0
#define ZF_LESS 1
#define ZF_EQUAL 2
#define ZF_LEQUAL 3
#define ZF_GREATER 4
#define ZF_NOTEQUAL 5
#define ZF_GEQUAL 6
#define ZF_ALWAYS 7
#define ZSRC_DEPTH 0
#define ZSRC_COLOR 1

/* alpha test */
#define AF_NEVER 0
#define AF_LESS 1
#define AF_EQUAL 2
#define AF_LEQUAL 3
#define AF_GREATER 4
#define AF_NOTEQUAL 5
#define AF_GEQUAL 6
#define AF_ALWAYS 7

/* smoothing */
#define SML_OFF 0
#define SML_ON 1
#define SML_SMOOTHER 2
#define SML_END_CORRECT 4
#define SMP_OFF 0
#define SMP_ON 1
#define SMP_SMOOTHER 2
#define PYSM_OFF 0
#define PYSM_ON 1
#define PYSM_SHRINK 2

/* blending */
#define BF_ZERO 0
#define BF_ONE 1
#define BF_DC 2
#define BF_SC 2
#define BF_MDC 3
#define BF_MSC 3
#define BF_SA 4
#define BF_MSA 5
#define BF_DA 6
#define BF_MDA 7
#define BF_MIN_SA_MDA 8
#define BF_CA 9
#define BF_MCA 10
#define BF_CC 11
#define BF_MCC 12
#define BF_MIN 13
#define BF_MAX 14

/* logical operations */
#define LO_ZERO 0x0
#define LO_AND 0x1
#define LO_ANDR 0x2
#define LO_SRC 0x3
#define LO_ANDI 0x4
#define LO_DST 0x5
#define LO_XOR 0x6
#define LO_OR 0x7
#define LO_NOR 0x8
#define LO_XNOR 0x9
#define LO_NDST 0xa
#define LO_ORR 0xb
#define LO_NSRC 0xc
#define LO_ORI 0xd
#define LO_NAND 0xe
#define LO_ONE 0xf

/* stencil, accumulation */
#define SF_NEVER 0
#define SF_LESS 1
#define SF_EQUAL 2
#define SF_LEQUAL 3
#define SF_GREATER 4
#define SF_NOTEQUAL 5
#define SF_GEQUAL 6
#define SF_ALWAYS 7
#define ST_KEEP 0
#define ST_ZERO 1
#define ST_REPLACE 2
#define ST_INCR 3
#define ST_DECR 4
#define ST_INVERT 5
#define AC_CLEAR 0
#define AC_ACCUMULATE 1
#define AC_CLEAR_ACCUMULATE 2
#define AC_RETURN 3
#define AC_MULT 4
#define AC_ADD 5

/* patterns, fonts */
#define PATTERN_16 16
#define PATTERN_32 32
#define PATTERN_64 64
#define PATTERN_16_SIZE 16
#define PATTERN_32_SIZE 64
#define PATTERN_64_SIZE 256

/* pixels */
#define SRC_NULL (-1)
#define SRC_AUTO 0
#define SRC_FRONT 1
#define SRC_BACK 2
#define SRC_ZBUFFER 3
#define SRC_PUP 4
#define SRC_OVER 5
#define SRC_UNDER 6
#define SRC_FRAMEGRABBER 7
#define PM_SHIFT 0
#define PM_EXPAND 1
#define PM_C0 2
#define PM_C1 3
#define PM_ADD24 4
#define PM_SIZE 5
#define PM_OFFSET 6
#define PM_STRIDE 7
#define PM_TTOB 8
#define PM_RTOL 9
#define PM_ZDATA 10

#include <gl/get.h>
#include <gl/words.h>

/* The font manager. */
typedef long fmfonthandle;
typedef void (*fmfaceproc)(char* face);
typedef struct {
    long printermatched, fixed_width, xorig, yorig, xsize, ysize, height, width;
    long nglyphs, matrix00, matrix01, matrix10, matrix11;
} fmfontinfo;

#ifndef GW_IRISGL_TOKENS_ONLY
#ifdef __cplusplus
extern "C" {
#endif
#include <gl/functions.h>
#ifndef __cplusplus
extern double atof(); /* <math.h> of IRIX had it */
/* An array of short, as other machines took, is filled with floats of the VGX, never beyond it. */
#define feedback(b, n) feedback((void*)(b), sizeof *(b) == 2 ? (n) / 2 : (n))
#define endfeedback(b) endfeedback((void*)(b))
#endif
#ifdef __cplusplus
}
#endif
#endif

#endif
