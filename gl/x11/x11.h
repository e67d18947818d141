// Xlib's headers, behind the headers of the machine: Xlib defines macros of the machine's words
// (None, Always). Included first in every file of this folder.
#pragma once

#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/draw/finish.h"
#include "gl/drawable/settings.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
