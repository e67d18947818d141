// The constants and types of IRIS GL, without its functions.
#pragma once

#define GW_IRISGL_TOKENS_ONLY
#include "irisgl/include/gl/device.h"
#include "irisgl/include/gl/gl.h"
