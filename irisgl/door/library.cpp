// libgl.so is gw::irisgl as a whole; a shared library needs a source of its own.
