# Pictures that the command writes are judged by OpenImageIO itself.
set(link gw::judge)
