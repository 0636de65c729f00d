#!/usr/bin/env python3
"""Touches an Xorg screen as a user would, through Xorg's input driver for tests (inputtest_drv).

Usage: touch_device.py SOCKET WIDTHxHEIGHT < GESTURES

The driver accepts only a single connection. Each line of the input is a gesture, which is answered by "done". Positions are in
screen pixels:
  tap X Y                          One finger touches the screen for 60 ms.
  double X Y                       There are two taps, 120 ms apart.
  drag X Y TO_X TO_Y               One finger moves in 20 steps and pauses before it is lifted.
  swing X Y TO_X TO_Y              One finger moves there and back again without being lifted.
  pinch X Y FROM TO [DEGREES]      Two fingers on opposite sides of a point change their distance and rotate clockwise.
  pan X Y TO_X TO_Y                Two fingers, 100 pixels apart, move in 20 steps.
  random SEED COUNT                There are COUNT events of up to four fingers, all of which are lifted at the end.
  wait SECONDS
"""
import math
import random
import socket
import struct
import sys
import time

BEGIN, UPDATE, END = 18, 19, 20  # XInput's touch events
STEP = 0.016


class Device:
    """A connection to the driver, which uses the messages of xf86-input-inputtest-protocol.h, version 1.0."""

    def __init__(self, path, width, height):
        self.size = width, height
        self.down = {}
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(10)
        self.socket.connect(path)
        self.socket.sendall(struct.pack("=IIHH", 12, 0, 1, 0))
        if struct.unpack("=IIHH", self.socket.recv(12))[1:3] != (0, 1):
            sys.exit("the driver speaks another version of the protocol")

    def touch(self, finger, kind, x, y):
        full = 65535.0  # of the device's axes
        values = [x / self.size[0] * full, y / self.size[1] * full] + [0.0] * 62
        body = struct.pack("=II", finger, kind) + struct.pack("=I8s4x", 0, b"\x03" + bytes(7))
        body += struct.pack("=64d", *values) + bytes(64 * 8)
        self.socket.sendall(struct.pack("=II", 8 + len(body), 6) + body)
        if kind == END:
            self.down.pop(finger, None)
        else:
            self.down[finger] = (x, y)

    def move(self, paths, rest=STEP):
        """Moves the fingers together along their paths, which are functions of t in [0, 1],
        then holds them for `rest` seconds before lifting them."""
        for finger, at in enumerate(paths):
            self.touch(finger, BEGIN, *at(0))
        for step in range(1, 21):
            time.sleep(STEP)
            for finger, at in enumerate(paths):
                self.touch(finger, UPDATE, *at(step / 20))
        time.sleep(rest)
        for finger, at in enumerate(paths):
            self.touch(finger, END, *at(1))

    def tap(self, x, y):
        self.touch(0, BEGIN, x, y)
        time.sleep(0.06)
        self.touch(0, END, x, y)

    def double(self, x, y):
        self.tap(x, y)
        time.sleep(0.12)
        self.tap(x + 3, y - 2)

    def drag(self, x, y, to_x, to_y):
        self.move([lambda t: (x + t * (to_x - x), y + t * (to_y - y))], rest=0.5)

    def swing(self, x, y, to_x, to_y):
        def at(t):
            there = 1 - abs(1 - 2 * t)
            return x + there * (to_x - x), y + there * (to_y - y)

        self.move([at], rest=0.5)

    def pan(self, x, y, to_x, to_y):
        self.move([lambda t, side=side: (x + side + t * (to_x - x), y + t * (to_y - y)) for side in (-50, 50)])

    def pinch(self, x, y, begin, end, degrees=0.0):
        def at(t, side):
            half, angle = side * (begin + t * (end - begin)) / 2, math.radians(degrees) * t
            return x + half * math.cos(angle), y + half * math.sin(angle)

        self.move([lambda t: at(t, -1), lambda t: at(t, 1)])

    def random(self, seed, count):
        chance = random.Random(int(seed))
        for _ in range(int(count)):
            finger = chance.randrange(4)
            x, y = chance.uniform(0, self.size[0]), chance.uniform(0, self.size[1])
            if finger not in self.down:
                self.touch(finger, BEGIN, x, y)
            elif chance.random() < 0.7:
                self.touch(finger, UPDATE, x, y)
            else:
                self.touch(finger, END, *self.down[finger])
            time.sleep(chance.choice((0, 0, 0.005, 0.02)))
        for finger, at in list(self.down.items()):
            self.touch(finger, END, *at)

    def wait(self, seconds):
        time.sleep(seconds)


def main():
    device = Device(sys.argv[1], *map(int, sys.argv[2].split("x")))
    time.sleep(0.3)
    for line in sys.stdin:
        words = line.split()
        if words:
            getattr(device, words[0])(*map(float, words[1:]))
            print("done", flush=True)


main()
