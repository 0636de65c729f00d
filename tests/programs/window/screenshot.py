#!/usr/bin/env python3
"""Writes the screen's contents, or a part of them, to a PPM file. Usage: screenshot.py FILE [LEFT TOP WIDTH HEIGHT]"""
import sys

from Xlib import X, display

screen = display.Display().screen()
part = [int(number) for number in sys.argv[2:]] or [0, 0, screen.width_in_pixels, screen.height_in_pixels]
wide, high = part[2:]
data = screen.root.get_image(*part, X.ZPixmap, 0xFFFFFFFF).data  # blue, green, red, unused
rgb = bytearray(wide * high * 3)
for channel in range(3):
    rgb[channel::3] = data[2 - channel :: 4]
with open(sys.argv[1], "wb") as file:
    file.write(b"P6 %d %d 255\n" % (wide, high) + rgb)
