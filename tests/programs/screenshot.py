#!/usr/bin/env python3
"""Writes what the screen shows to a PPM file. usage: screenshot.py FILE"""
import sys

from Xlib import X, display

screen = display.Display().screen()
wide, high = screen.width_in_pixels, screen.height_in_pixels
data = screen.root.get_image(0, 0, wide, high, X.ZPixmap, 0xFFFFFFFF).data  # blue, green, red, unused
rgb = bytearray(wide * high * 3)
for channel in range(3):
    rgb[channel::3] = data[2 - channel :: 4]
with open(sys.argv[1], "wb") as file:
    file.write(b"P6 %d %d 255\n" % (wide, high) + rgb)
