# Embree is an oracle here and a peer in bench/, never a dependency of the product.
find_package(embree 3 REQUIRED)
set(link embree)
