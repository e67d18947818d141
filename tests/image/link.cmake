# What our files hold is judged by OpenImageIO itself; files that it does not write are made by
# libpng itself.
find_package(OpenImageIO REQUIRED)
find_package(PNG REQUIRED)
set(link OpenImageIO::OpenImageIO PNG::PNG)
