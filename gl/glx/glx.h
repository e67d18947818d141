// GLX's headers, behind those of the machine and of Xlib. Included first in every file of this folder.
#pragma once

#include "gl/x11/x11.h"

#define GLX_GLXEXT_PROTOTYPES
#include <GL/glx.h>
