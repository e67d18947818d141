# What our files hold is judged by OpenImageIO itself; files that it does not write are made by
# libpng itself.
find_package(PNG REQUIRED)
set(link gw_judge_loader PNG::PNG)
