# Never ends.
while true; do true; done
