# What our files hold is judged by OpenImageIO itself.
find_package(OpenImageIO REQUIRED)
set(link OpenImageIO::OpenImageIO)
