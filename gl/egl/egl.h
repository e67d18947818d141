// EGL's headers, behind those of the machine and of Xlib. Included first in every file of this folder.
#pragma once

#include "gl/x11/x11.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
