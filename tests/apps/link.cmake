# Pictures that the command writes are judged by OpenImageIO itself.
find_package(OpenImageIO REQUIRED)
set(link OpenImageIO::OpenImageIO)
