/* What feedback puts into its buffer: a word, how many numbers follow, and these. docs/irisgl.md */
#ifndef GW_IRISGL_FEED_H
#define GW_IRISGL_FEED_H
#define FB_POLYGON (72.0)
#define FB_POINT (95.0)
#define FB_LINE (113.0)
#define FB_CMOV (163.0)
#define FB_PASSTHROUGH (176.0)
#endif
