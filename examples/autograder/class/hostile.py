"""Tries to use up processes and disk, to read what is not its own, and to reach the network."""
import os
import socket
import sys
import time


def tried(what, act):
    try:
        print(what, act(), file=sys.stderr)
    except OSError as error:
        print(what, error.strerror, file=sys.stderr)


def fill_the_disk():
    with open("full", "wb") as file:
        while True:
            file.write(bytes(1 << 20))


def fork_until_refused():
    while os.fork():
        pass
    time.sleep(1000)


tried("other files:", lambda: os.listdir("/home"))
tried("the submission:", lambda: open("/submission/hostile.py", "a"))
tried("network:", lambda: socket.create_connection(("192.0.2.1", 80), 1))
tried("disk:", fill_the_disk)
tried("processes:", fork_until_refused)
sys.exit(1)
