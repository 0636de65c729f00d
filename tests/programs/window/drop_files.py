#!/usr/bin/env python3
"""Drops files on a window as a file manager would (XDND). Usage: drop_files.py WINDOW FILE..."""
import pathlib
import select
import sys
import time

from Xlib import X, display
from Xlib.protocol import event

screen = display.Display()
window = screen.create_resource_object("window", int(sys.argv[1]))
uris = "".join(pathlib.Path(f).absolute().as_uri() + "\r\n" for f in sys.argv[2:]).encode()
source = screen.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)


def atom(name):
    return screen.intern_atom(name)


def send(kind, *data):
    numbers = [source.id, *data] + [0] * (4 - len(data))
    window.send_event(event.ClientMessage(window=window, client_type=atom(kind), data=(32, numbers)))
    screen.flush()


def answer(request):
    """Answers the request for the names of the files."""
    request.requestor.change_property(request.property, request.target, 8, uris)
    request.requestor.send_event(event.SelectionNotify(time=request.time, requestor=request.requestor,
                                                       selection=request.selection, target=request.target,
                                                       property=request.property))
    screen.flush()


def await_message(kind, seconds=20):
    """Whether the window has sent this message; the window's requests are answered in the meantime."""
    until = time.time() + seconds
    while time.time() < until:
        while screen.pending_events():
            e = screen.next_event()
            if e.type == X.SelectionRequest:
                answer(e)
            elif e.type == X.ClientMessage and e.client_type == atom(kind):
                return True
        select.select([screen], [], [], max(0, until - time.time()))
    return False


source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)
send("XdndEnter", 5 << 24, atom("text/uri-list"))
send("XdndPosition", 0, 200 << 16 | 200, X.CurrentTime, atom("XdndActionCopy"))
if not await_message("XdndStatus"):
    sys.exit("the window does not take files")
send("XdndDrop", 0, X.CurrentTime)
if not await_message("XdndFinished"):
    sys.exit("the files were not taken")
